// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "compare/figure/figure_numbers.h"
#include "compare/figure/figure_request.h"
#include "compare/figure/figure_rows.h"
#include "core/raster.h"

namespace pellucid::compare {

/// A FigureScale is what the colours of a line of maps mean.
struct FigureScale {
  std::string title;
  Image colors;                                                // of one row, from left to right
  std::vector<std::pair<double, std::vector<TextRun>>> ticks;  // at shares of the way
};

/// FigureMaps are one line of maps, one for each column; an empty one stands for the reference.
struct FigureMaps {
  FigureScale scale;
  std::vector<Image> maps;
};

/// A FigureStrip is all that a figure has of one scene.
struct FigureStrip {
  std::string label;  // beside it; empty: none
  std::vector<Image> pictures;
  std::vector<Crop> crops;
  std::vector<FigureMaps> lines_of_maps;
  std::vector<FigureNumbers> numbers;
};

/// A FigureHeading stands above a column: a method, and with which parameters.
struct FigureHeading {
  std::string title, parameters;
};

/// A FigureContent is what a figure shows, before it is laid out.
struct FigureContent {
  std::vector<FigureHeading> headings;
  std::vector<FigureStrip> strips;
};

/// Returns what stands above each column: the request's labels, or methods' titles and parameters.
/// Throws InputError for labels that are not as many as the columns.
std::vector<FigureHeading> figure_headings(const FigureRows& scene, const FigureRequest& request);

/// Returns what stands beside each scene: the request's labels, or names where there are several.
/// Throws likewise.
std::vector<std::string> scene_labels(const std::vector<FigureRows>& scenes,
                                      const FigureRequest& request);

/// Reads the pictures that a figure shows. Throws InputError as find_figure_rows() does; for
/// pictures that are missing or of several sizes; for a crop that is not within them; for labels
/// that are not as many as the columns or scenes; and for maps where the reference has no picture.
FigureContent read_figure(const PastRun& run, const FigureRequest& request);

}  // namespace pellucid::compare
