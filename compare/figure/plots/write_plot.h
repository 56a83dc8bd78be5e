// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/figure/plots/plot_content.h"
#include "compare/figure/write_figure.h"

namespace pellucid::compare {

/// Writes a plot of a run's numbers by the ending of `path`: PDF, SVG, PNG, or its points as CSV.
/// The file appears whole or not at all. Throws as read_plot(), lay_out_plot() and OutputFile do,
/// and InputError for another ending.
WrittenFigure write_plot(const std::filesystem::path& path, const PastRun& run,
                         const PlotRequest& request, const FigureStyle& style);

}  // namespace pellucid::compare
