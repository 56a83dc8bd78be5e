// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "compare/figure/figure_rows.h"
#include "compare/figure/figure_sheet.h"

namespace pellucid::compare {

/// FigureNumbers are what stands below a picture: a list of numbers each of its errors and of its
/// costs.
struct FigureNumbers {
  std::vector<std::vector<TextRun>> errors, costs;
};

/// Returns the numbers of these columns below each of a scene's pictures: "SSIM 0.981", "12.5 ms".
/// Bold is the best of two or more, without the reference, and what its interval is not told from
/// it. The reference has costs alone. Throws InputError for an unknown column.
std::vector<FigureNumbers> figure_numbers(const FigureRows& rows,
                                          const std::vector<std::string>& columns);

}  // namespace pellucid::compare
