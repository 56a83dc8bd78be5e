// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "integrators/paths/magnitude.h"

namespace pellucid::integrators {

/// Returns a vector along the normal of the triangle a, b, c, whose length is the sine of the angle
/// at a; exactly 0 where the triangle has no area, however small it is.
inline Vec3 facet_sine(const Vec3& a, const Vec3& b, const Vec3& c) {
  return glm::cross(direction_of(b - a), direction_of(c - a));
}

/// Returns true unless the triangle is a line, but for rounding, or a point, as of particles that
/// rest at one place or stand on one side of the field's domain.
inline bool has_area(const Vec3& a, const Vec3& b, const Vec3& c) {
  constexpr double rounding = 1e-14;  // of the longest side's square
  const double ab = magnitude(b - a), ac = magnitude(c - a);
  const double longest = std::max({ab, ac, magnitude(c - b)});
  return magnitude(facet_sine(a, b, c)) * (ab / longest) * (ac / longest) > rounding;
}

}  // namespace pellucid::integrators
