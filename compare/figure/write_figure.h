// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "compare/changes/past_run.h"
#include "compare/figure/figure_request.h"
#include "compare/figure/figure_rows.h"

namespace pellucid::compare {

/// A WrittenFigure says what was written.
struct WrittenFigure {
  std::vector<std::filesystem::path> files;
  double width = 0, height = 0;          // points
  std::vector<FigureRows> rows;          // that it shows, by scene
  std::vector<std::vector<Crop>> crops;  // by scene
};

/// Writes a figure of a run's pictures by the ending of `path`: PDF, SVG, PNG, or LaTeX, beside
/// which lies a PDF, NAME-pictures.pdf. `command` made it. Each file appears whole or not at all.
/// Throws as read_figure(), lay_out() and OutputFile do, and InputError for another ending, or for
/// a name that LaTeX does not include.
WrittenFigure write_figure(const std::filesystem::path& path, const PastRun& run,
                           const FigureRequest& request, const FigureStyle& style,
                           const std::string& command);

/// Writes the numbers of the same rows as a table of LaTeX, latex_figure_table(), to a path that
/// ends in .tex. Throws as find_figure_rows(), latex_figure_table() and OutputFile do, and
/// InputError for another ending and where no number is asked for.
WrittenFigure write_figure_table(const std::filesystem::path& path, const PastRun& run,
                                 const FigureRequest& request, const FigureStyle& style,
                                 const std::string& command);

}  // namespace pellucid::compare
