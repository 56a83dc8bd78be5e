// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/view/unit_scale.h"

#include <algorithm>
#include <cmath>

namespace pellucid::scene {

double unit_scale(const Box3& box) {
  if (box.empty()) return 1;
  const Vec3 half = 0.5 * box.max - 0.5 * box.min;
  const double largest = std::max({half.x, half.y, half.z});
  return largest > 0 ? std::exp2(-std::ceil(std::log2(largest))) : 1;
}

Vec3 with_unit_exponent(const Vec3& v) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!(largest > 0) || !std::isfinite(largest)) return v;
  const int exponent = std::ilogb(largest);
  const auto scaled = [&](double x) { return std::ldexp(x, -exponent); };
  return {scaled(v.x), scaled(v.y), scaled(v.z)};
}

Vec3 normalized_or_zero(const Vec3& v) {
  const Vec3 scaled = with_unit_exponent(v);
  const double length = glm::length(scaled);
  return length > 0 ? scaled / length : v;
}

}  // namespace pellucid::scene
