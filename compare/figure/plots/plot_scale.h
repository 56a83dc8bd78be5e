// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "compare/figure/figure_sheet.h"
#include "compare/figure/plots/plot.h"

namespace pellucid::compare {

/// A PlotTick is a place on an axis with what is written there.
struct PlotTick {
  double at = 0;  // points from the axis's begin
  std::vector<TextRun> label;
};

/// A PlotScale places numbers along an axis.
class PlotScale {
 public:
  /// Makes an axis of `length` points that has room for these numbers; those that are not finite do
  /// not count.
  PlotScale(std::vector<double> numbers, const PlotAxis& axis, double length);

  /// Returns the place of a number, in points from the axis's begin.
  double at(double number) const;
  /// Returns ticks at round numbers, ascending; the rail's first, if there is one.
  const std::vector<PlotTick>& ticks() const { return ticks_; }
  /// Returns how many points of the axis its rail takes; 0 without one.
  double rail() const { return rail_; }

 private:
  void choose_domain(std::vector<double> numbers);
  void add_decades();
  void add_steps(double step);
  void add(double number, std::vector<TextRun> label);
  /// The number, or its logarithm.
  double measure(double number) const;

  PlotAxis axis_;
  double length_, rail_ = 0;
  double low_ = 0, high_ = 1;  // as measure() has them
  std::vector<PlotTick> ticks_;
};

/// Returns 2 as "2", 0.000002 as "2·10" with a raised "−6"; a power of ten as such alone.
std::vector<TextRun> tick_label(double number);

}  // namespace pellucid::compare
