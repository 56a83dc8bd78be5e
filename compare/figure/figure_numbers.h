// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "compare/figure/figure_rows.h"
#include "compare/figure/figure_sheet.h"
#include "compare/results/columns.h"

namespace pellucid::compare {

/// FigureNumbers are what stands below a picture: a list of numbers each of its errors and of its
/// costs.
struct FigureNumbers {
  std::vector<std::vector<TextRun>> errors, costs;
};

/// Returns the numbers of these columns below each of a scene's pictures: "SSIM 0.981", "12.5 ms".
/// Bold is the best of two or more, without the reference, and, with a raised *, what its interval
/// is not told from it. The reference has costs alone. Throws InputError for an unknown column.
std::vector<FigureNumbers> figure_numbers(const FigureRows& rows,
                                          const std::vector<std::string>& columns);

/// Returns a column's number of a row without its unit, in few digits: errors below a thousandth
/// with an exponent. What a row lacks is a dash.
std::vector<TextRun> plain_number(const Column& column, const ResultRow& row);

/// Returns whether a column is measured against the reference, which then has none.
bool is_error(const Column& column);

/// Returns whether the row has the best number of two or more, or one that is not told from it.
bool is_best_of_several(const Column& column, const ResultRow& row,
                        std::span<const ResultRow> rows);

/// Returns whether a row among the best has another number than the best row, from which only its
/// interval does not tell it. Some row has to have a number.
bool is_only_tied(const Column& column, const ResultRow& row, std::span<const ResultRow> rows);

}  // namespace pellucid::compare
