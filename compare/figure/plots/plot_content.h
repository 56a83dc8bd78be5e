// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "compare/changes/past_run.h"
#include "compare/figure/figure_request.h"
#include "compare/figure/plots/plot.h"

namespace pellucid::compare {

/// A PlotRequest says what is plotted of a study's results.
struct PlotRequest {
  /// "trade-off": `y` over `x`, a mark for each call, and the front of those that none beats in
  /// both; "sweep:METHOD": `y` over the one parameter in which the method's calls differ;
  /// "curves:NAME": curves of results.json, "layer error".
  std::string kind = "trade-off";
  std::string x = "seconds", y = "rmse";  // columns or measures
  std::vector<std::string> scenes = {};   // a panel each; empty: all
  std::vector<std::string> methods = {};  // as FigureRequest's; empty: all that did not fail
  bool logarithmic_x = false, logarithmic_y = false;  // a trade-off is so in any case
};

/// Errors up to it are the rounding of floats: on a logarithmic axis they stand on its rail.
constexpr double smallest_error = 1e-7;

/// Returns the plot. The reference's cost is a dashed line of a trade-off; its curves are among the
/// others. Throws InputError for an unknown kind, scene, method, column or curve, and where there
/// is nothing to be seen.
Plot read_plot(const PastRun& run, const PlotRequest& request);

/// Returns a line of CSV for each point: scene, label, and both numbers, with all digits.
std::string csv_of(const Plot& plot);

}  // namespace pellucid::compare
