// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/raster.h"

namespace pellucid::compare {

/// Shifts are looked for up to so many pixels in each direction.
inline constexpr int farthest_shift = 4;

/// A KnownRaster is a number of every pixel, and whether it is known: 1 or 0.
struct KnownRaster {
  Raster<double> values, weights;
};

/// RasterPairs are rasters of the reference and of the test, of the same quantities and all of one
/// size, of more than twice farthest_shift; of each row and column one pixel of `stride` counts.
struct RasterPairs {
  std::vector<KnownRaster> reference;
  std::vector<Raster<double>> test;
  int stride = 1;
};

/// Returns the mean square of test(x) - reference(x - shift), drawn between pixels linearly, where
/// the latter is known; infinite where nothing is.
double apart(const RasterPairs& pairs, const Vec2& shift);

/// A RegistrationStep is what a step of Gauss and Newton towards the least of apart() is made of.
struct RegistrationStep {
  glm::dmat2 normal{0};  // Σ g gᵀ, of the reference's gradients per pixel
  Vec2 right{0};
  double squares = 0, count = 0;  // of what differs

  bool is_determined() const { return glm::determinant(normal) > 1e-12; }
};

/// Returns the step from this shift.
RegistrationStep step_at(const RasterPairs& pairs, const Vec2& shift);

/// Returns the shift, in pixels, at which apart() is least: from the best whole pixels by least
/// squares until they converge; nothing where gradients of one direction are missing, or where they
/// leave what is searched.
std::optional<Vec2> registered_shift(const RasterPairs& pairs);

}  // namespace pellucid::compare
