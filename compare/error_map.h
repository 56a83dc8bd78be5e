#pragma once

#include <vector>

#include "core/raster.h"

namespace pellucid {

/// The one scale of every error map: a pixel's largest RGB difference, logarithmic from `min` (a
/// quarter of an 8-bit step: nothing a screen could show) to `max` (white for black).
struct ErrorScale {
  static constexpr double min = 1e-3;
  static constexpr double max = 1;

  /// Colour of an error; those outside have the colour of the nearer end.
  static Vec3 color(double error);
};

/// Both pictures have one size.
Image error_map(const Image& reference, const Image& test);

/// Largest RGB difference of two pixels.
double pixel_error(const Rgba& a, const Rgba& b);

}  // namespace pellucid
