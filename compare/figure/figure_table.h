// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "compare/figure/figure_latex.h"
#include "compare/figure/figure_request.h"
#include "compare/figure/figure_rows.h"

namespace pellucid::compare {

/// Returns a table environment of LaTeX (table* across columns): a block for each scene, a line for
/// each method, the reference's in italics, the columns of `request.numbers` with their 95 %
/// intervals. The best number of two or more is bold; so is, with a star, what its interval does
/// not tell from it. It needs booktabs. Throws InputError for an unknown column, and as
/// figure_headings() and scene_labels() do.
std::string latex_figure_table(const std::vector<FigureRows>& scenes, const FigureRequest& request,
                               const FigureWidth& width, const FigureCaption& caption);

}  // namespace pellucid::compare
