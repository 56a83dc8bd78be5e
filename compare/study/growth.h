// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "compare/results/columns.h"

namespace pellucid::compare {

/// A Growth is a row of scenes that differ in one size: how do numbers grow with it?
struct Growth {
  std::string title;                                   // the size: "Points"
  std::vector<const Column*> by;                       // what grows: seconds, bytes
  std::vector<std::pair<std::string, double>> scenes;  // with their sizes, which are above 0
};

/// A PowerLaw is y = c x^p through the points of a curve, by least squares of log y over log x.
struct PowerLaw {
  double exponent = 0;               // p
  std::optional<Interval> interval;  // 95 % of p, by Student's t; nothing for two points
  double last_exponent = 0;          // between the two largest sizes
};

/// Returns the power law through points of x and y; nothing where fewer than two of different x
/// have both above 0 and finite. The interval is that of the scatter about the law: where a curve
/// is no power law, as where a constant cost ends, it is wide.
std::optional<PowerLaw> power_law(std::span<const std::pair<double, double>> points);

/// A GrowthCurve is what one call needs over the sizes, ascending, where it is known.
struct GrowthCurve {
  std::string call;
  std::vector<std::pair<double, double>> points;  // size, number in the column's unit
  std::optional<PowerLaw> law;
};

/// Returns a curve for each call that has a number of the column in one of the scenes, in the order
/// of the rows, the reference among them.
std::vector<GrowthCurve> growth_curves(const Growth& growth, const Column& column,
                                       std::span<const ResultRow> rows);

/// Returns "1.02 (0.97–1.07), last 1.00": the exponent, its interval, and that of the last step;
/// "–" where there is none.
std::string text_of(const std::optional<PowerLaw>& law);

}  // namespace pellucid::compare
