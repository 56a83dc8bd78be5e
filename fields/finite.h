// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "core/vec.h"

namespace pellucid::fields {

/// Returns true when every component is finite: neither infinite nor NaN.
///@{
inline bool is_finite(const Vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

inline bool is_finite(const Mat3& m) {
  return is_finite(m[0]) && is_finite(m[1]) && is_finite(m[2]);
}
///@}

}  // namespace pellucid::fields
