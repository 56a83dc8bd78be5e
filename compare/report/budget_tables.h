// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "compare/results/result_row.h"

namespace pellucid::compare {

/// Returns a line for each cell and stage: scene, method, parameters, stage, refinement, share,
/// share_first, share_last, rmse, gain, seconds, gain_per_second, why_not; then one for the
/// interaction and one for the whole. Empty where no row has an error budget.
std::string csv_budgets(std::span<const ResultRow> rows);

/// Returns the same for people, a table for each cell that has a budget. Empty where none has.
std::string markdown_budgets(std::span<const ResultRow> rows);

}  // namespace pellucid::compare
