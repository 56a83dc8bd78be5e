// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "integrators/paths/magnitude.h"

namespace pellucid::integrators {

/// Returns a vector along the normal of the triangle a, b, c, whose length is the sine of the angle
/// at a; exactly 0 where the triangle has no area, however small it is.
inline Vec3 facet_sine(const Vec3& a, const Vec3& b, const Vec3& c) {
  return glm::cross(direction_of(b - a), direction_of(c - a));
}

/// Returns true unless the triangle is a line or a point, as of particles that rest at one place.
inline bool has_area(const Vec3& a, const Vec3& b, const Vec3& c) {
  return facet_sine(a, b, c) != Vec3(0);
}

}  // namespace pellucid::integrators
