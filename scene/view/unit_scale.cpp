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

}  // namespace pellucid::scene
