// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/raster.h"

namespace pellucid::compare {

/// Colour of a value on a logarithmic scale from `min` to `max`; values outside have the colour of
/// the nearer end.
Vec3 logarithmic_color(double value, double min, double max);

/// The one scale of every error map: a pixel's largest RGB difference, logarithmic from `min` (a
/// quarter of an 8-bit step: nothing a screen could show) to `max` (white for black).
struct ErrorScale {
  static constexpr double min = 1e-3;
  static constexpr double max = 1;

  static Vec3 color(double error) { return logarithmic_color(error, min, max); }
};

/// Both pictures have one size.
Image error_map(const Image& reference, const Image& test);

/// Largest RGB difference of two pixels.
double pixel_error(const Rgba& a, const Rgba& b);

}  // namespace pellucid::compare
