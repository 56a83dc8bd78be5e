// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>

#include "compare/results/result_row.h"
#include "compare/study/study.h"

namespace pellucid::compare {

// What results and the report's page say of a study and its source.

/// Returns {"name", "title", "source", "notes"}, and "opacities" where a call optimizes them.
nlohmann::json study_json(const Study& study);

/// Returns the texts of the study's file and of its scenes': [{"file", "text"}]; those that can no
/// longer be read are left out.
nlohmann::json inputs_json(const Study& study);

/// Returns each claim with its checks: [{"text", "by", "checks": [{"of", "values": [{"of",
/// "text"}], "against", "undecided"}]}].
nlohmann::json claims_json(const Study& study, std::span<const ResultRow> rows);

/// Returns where each call breaks: {"heads": […], "lines": [{"call", "cells": […]}]}; no lines
/// where the study has no ladders.
nlohmann::json ladders_json(const Study& study, std::span<const ResultRow> rows);

/// Returns what grows with which size: a plot each, with a curve and its power law for each call.
/// Empty where the study has no growth.
nlohmann::json growth_json(const Study& study, std::span<const ResultRow> rows);

/// Returns {"tables": […], "ratios": […], "reference": CALL}: times in milliseconds, bytes as they
/// are; empty lists where the study has no costs of its source.
nlohmann::json costs_json(const Study& study, std::span<const ResultRow> rows);

}  // namespace pellucid::compare
