// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "compare/results/result_row.h"

namespace pellucid::compare {

/// A loop of fixed arithmetic that took longer than at its best by this part was disturbed.
constexpr double disturbed_by = 0.2;
/// A machine whose loop takes longer, or shorter, in the last third of a study than in the first by
/// this part has drifted.
constexpr double drifted_by = 0.1;

/// Returns one sentence for each reason to doubt the times of these rows, by what a loop of fixed
/// arithmetic took beside them (Calibration) on the one machine that they come from:
///
/// - a row's loop took longer than the best tenth of all loops by `disturbed_by`: another program
///   had the processors, or their clock had sunk;
/// - of six loops or more, the medians of the first and of the last third, by the clock, differ by
///   `drifted_by`;
/// - rows reached the largest number of repeats before their interval was as narrow as asked.
std::vector<std::string> time_warnings(std::span<const ResultRow> rows);

}  // namespace pellucid::compare
