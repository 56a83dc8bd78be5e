// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A plot before it lies on paper: numbers as people read them, and what joins them.

#include <string>
#include <vector>

#include "core/vec.h"

namespace pellucid::compare {

/// A PlotAxis says what an axis is of.
struct PlotAxis {
  std::string title;  // "Time [ms]"
  bool logarithmic = false;
  /// Numbers up to it have no place on a logarithmic axis: they stand on a rail before its begin.
  double least = 0;
};

/// A PlotSeries is what has one colour and mark.
struct PlotSeries {
  std::string label;         // in the legend
  std::vector<Vec2> points;  // in the axes' units
  bool is_joined = false;    // by a line, in their order
};

/// A PlotPanel is one plot of those that share axes' titles and a legend.
struct PlotPanel {
  std::string title;  // stands above it where there are several
  std::vector<PlotSeries> series;
  std::vector<Vec2> front;        // joined by stairs, behind the points; ascending in x
  std::vector<double> verticals;  // x of dashed lines
};

/// A Plot is a figure of panels.
struct Plot {
  PlotAxis x, y;
  std::vector<PlotPanel> panels;
  std::string of_verticals;  // their label in the legend
};

}  // namespace pellucid::compare
