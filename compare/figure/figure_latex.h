// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "compare/figure/figure_request.h"
#include "compare/figure/figure_sheet.h"

namespace pellucid::compare {

/// Returns runs of text as LaTeX sets them, escaped.
std::string latex_runs(const std::vector<TextRun>& runs);

/// FigureCaption is what LaTeX sets around a figure.
struct FigureCaption {
  std::string text;           // as it stands: it is escaped
  std::string label;          // of \label
  std::string command;        // that made the figure, for a comment
  std::string warnings = {};  // lines of comment: see latex_warnings()
};

/// Returns a figure environment (figure* across columns) that includes `pictures`, a PDF without
/// texts, and sets the sheet's texts over it in the document's own font. It needs graphicx alone,
/// and scales with the line's width.
std::string latex_figure(const FigureSheet& sheet, const std::string& pictures,
                         const FigureWidth& width, const FigureCaption& caption);

}  // namespace pellucid::compare
