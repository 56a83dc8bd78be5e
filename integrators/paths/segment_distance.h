// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "core/vec.h"

namespace pellucid::integrators {

/// Returns the distance of x from the segment between a and b, world units.
inline double distance_to_segment(const Vec3& x, const Vec3& a, const Vec3& b) {
  const Vec3 ab = b - a;
  const double length2 = glm::dot(ab, ab);
  const double u = length2 > 0 ? std::clamp(glm::dot(x - a, ab) / length2, 0.0, 1.0) : 0;
  return glm::distance(x, a + u * ab);
}

}  // namespace pellucid::integrators
