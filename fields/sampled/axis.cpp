// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/sampled/axis.h"

#include <cassert>
#include <cmath>
#include <utility>

namespace pellucid::fields {

Axis::Axis(std::vector<double> positions) : positions_(std::move(positions)) {
  assert(positions_.size() >= 2);
}

bool Axis::can_be_uniform(double first, double spacing, std::size_t count) {
  const double last = first + spacing * double(count - 1);
  return count >= 2 && spacing > 0 && std::isfinite(1 / spacing) && std::isfinite(last) &&
         first + spacing > first && last - spacing < last;
}

Axis Axis::uniform(double first, double spacing, std::size_t count) {
  assert(can_be_uniform(first, spacing, count));
  std::vector<double> positions(count);
  for (std::size_t i = 0; i < count; ++i) positions[i] = first + double(i) * spacing;
  Axis axis(std::move(positions));
  axis.inverse_spacing_ = 1 / spacing;
  return axis;
}

double Axis::smallest_width() const {
  double smallest = width(0);
  for (std::size_t i = 1; i + 1 < size(); ++i) smallest = std::min(smallest, width(i));
  return smallest;
}

CubicInterpolation::CubicInterpolation(const Axis& axis) {
  assert(axis.size() >= support);
  slopes_.reserve(axis.size());
  for (std::size_t i = 0; i < axis.size(); ++i) {
    const std::size_t first = std::clamp<std::size_t>(i, 1, axis.size() - 2) - 1;
    const double a = axis.position(first), b = axis.position(first + 1),
                 c = axis.position(first + 2), x = axis.position(i);
    // Derivatives at x of the Lagrange polynomials of a, b, c.
    slopes_.push_back(
        {first,
         {(2 * x - b - c) / ((a - b) * (a - c)), (2 * x - a - c) / ((b - a) * (b - c)),
          (2 * x - a - b) / ((c - a) * (c - b))}});
  }
}

Stencil<4> CubicInterpolation::stencil(const Axis& axis, double p) const {
  const auto [i, s, inverse_width] = axis.locate(p);
  const double h = axis.width(i), r = 1 - s;
  Stencil<4> result{std::clamp<std::size_t>(i, 1, axis.size() - 3) - 1, {}, {}};
  const auto add = [&result](std::size_t sample, double value, double slope) {
    result.value[sample - result.first] += value;
    result.slope[sample - result.first] += slope;
  };
  // The Hermite basis on [0, 1] and its derivatives.
  add(i, r * r * (1 + 2 * s), -6 * s * r * inverse_width);
  add(i + 1, s * s * (1 + 2 * r), 6 * s * r * inverse_width);
  const double tangent[2] = {s * r * r * h, -s * s * r * h};
  const double tangent_slope[2] = {r * (r - 2 * s), s * (s - 2 * r)};
  for (std::size_t end = 0; end < 2; ++end) {
    const Slope& slope = slopes_[i + end];
    for (std::size_t k = 0; k < 3; ++k)
      add(slope.first + k, tangent[end] * slope.weight[k], tangent_slope[end] * slope.weight[k]);
  }
  return result;
}

}  // namespace pellucid::fields
