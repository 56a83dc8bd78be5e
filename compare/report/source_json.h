// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>

#include "compare/results/result_row.h"
#include "compare/study/study.h"

namespace pellucid::compare {

// What the report's page says of a study's source.

/// Returns each claim with its checks: [{"text", "by", "checks": [{"scene", "values",
/// "against"}]}].
nlohmann::json claims_json(const Study& study, std::span<const ResultRow> rows);

/// Returns {"tables": […], "ratios": […], "reference": CALL}: times in milliseconds, bytes as they
/// are; empty lists where the study has no costs of its source.
nlohmann::json costs_json(const Study& study, std::span<const ResultRow> rows);

}  // namespace pellucid::compare
