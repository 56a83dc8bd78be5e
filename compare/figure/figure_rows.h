// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compare/changes/past_run.h"
#include "compare/figure/figure_request.h"

namespace pellucid::compare {

/// FigureRows are the rows of one scene that a figure shows, from left to right.
struct FigureRows {
  std::string scene;
  std::optional<ResultRow> reference;  // nothing where it failed or is not there
  std::vector<ResultRow> rows;
};

/// Splits "weighted-average,binning:bins=11,mode=linear" into calls: what has an '=' and no ':'
/// goes on with the call before it.
std::vector<std::string> methods_of_text(std::string_view text);

/// Finds the rows of a figure. Each of `request.methods` is a call, a list of them, or the name of
/// a method for all of its calls. Throws InputError for a scene or method that the run does not
/// have (the nearest names first), and for a cell that is missing or failed.
std::vector<FigureRows> find_figure_rows(const PastRun& run, const FigureRequest& request);

/// Returns the rows of all scenes, one after another.
std::vector<ResultRow> rows_in(const std::vector<FigureRows>& scenes);

}  // namespace pellucid::compare
