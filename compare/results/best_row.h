// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "compare/results/columns.h"

namespace pellucid::compare {

/// Returns the row with the best value of a column, without the reference and those that failed;
/// null where no way is better, or no row has one.
const ResultRow* best_row(const Column& column, std::span<const ResultRow> rows);

/// Returns whether several rows have a number of a column whose numbers have intervals, but the
/// best has none, as of times from fewer than five pictures: no number is then told to be the best.
bool is_undecided(const Column& column, std::span<const ResultRow> rows);

/// Returns whether the row has the best value of a method, or one that is not told from it; false
/// where that is undecided.
bool is_among_best(const Column& column, const ResultRow& row, std::span<const ResultRow> rows);

}  // namespace pellucid::compare
