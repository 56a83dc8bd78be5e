// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "compare/results/columns.h"

namespace pellucid::compare {

/// Returns the row with the best value of a column, without the reference and those that failed;
/// null where no way is better, or no row has one.
const ResultRow* best_row(const Column& column, std::span<const ResultRow> rows);

/// Returns whether the row has the best value of a method, or one that is not told from it.
bool is_among_best(const Column& column, const ResultRow& row, std::span<const ResultRow> rows);

}  // namespace pellucid::compare
