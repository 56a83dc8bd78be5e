// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "core/vec.h"

namespace pellucid::integrators {

/// Returns the length of a vector, in its own unit, also where the squares of its components leave
/// a double's range: a flow of 1e-200 per unit of time moves in 1e200 of them.
inline double magnitude(const Vec3& v) {
  const double squared = glm::dot(v, v);
  if ((squared > 1e-280 && squared < 1e300) || std::isnan(squared)) return std::sqrt(squared);
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (largest == 0 || std::isinf(largest)) return largest;
  return largest * glm::length(v / largest);
}

/// Returns the direction of a vector, of length 1; 0 of one that has none.
inline Vec3 direction_of(const Vec3& v) {
  const double length = magnitude(v);
  return length > 0 ? v / length : Vec3(0);
}

}  // namespace pellucid::integrators
