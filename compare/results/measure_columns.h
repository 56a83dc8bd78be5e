// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "compare/results/result_row.h"

namespace pellucid::compare {

/// Every measure that some row has, once, in the order of its first row; values are that row's.
std::vector<scene::Measure> measure_columns(std::span<const ResultRow> rows);

/// Nothing where the row has no such measure.
std::optional<double> measure_of(const ResultRow& row, std::string_view name);

/// "Integration [s]".
std::string heading(const scene::Measure& measure);

}  // namespace pellucid::compare
