// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/pictures/picture_text.h"
#include "core/raster.h"

namespace pellucid::compare {

/// Returns the colour of a value on a logarithmic scale from `min` to `max`, both above 0; values
/// outside have the colour of the nearer end.
Vec3 logarithmic_color(double value, double min, double max);

/// The ErrorScale is the one scale of every error map: a pixel's largest RGB difference,
/// logarithmic from `min` (a quarter of an 8-bit step: nothing a screen could show) to `max` (white
/// for black).
struct ErrorScale {
  static constexpr double min = 1e-3;
  static constexpr double max = 1;

  static Vec3 color(double error) { return logarithmic_color(error, min, max); }
};

/// Returns a picture that colours each pixel's error by the ErrorScale. Both pictures have one
/// size.
Image error_map(const Image& reference, const Image& test);

/// Returns how such a map is written.
PictureForm form_of_error_map();

/// Returns the largest absolute difference of two pixels in red, green or blue.
double pixel_error(const Rgba& a, const Rgba& b);

}  // namespace pellucid::compare
