// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/sums/composite.h"

#include <cmath>

#include "groundtruth/sums/front_to_back.h"

namespace pellucid::groundtruth {

Composite composite(const CrossingFinder& finder, std::span<const Crossing> crossings,
                    const Vec3& background, const Vec3& world_direction, double stop_below) {
  FrontToBack sum;
  std::uint32_t layers = 0;
  for (const Crossing& crossing : crossings) {
    const Fragment fragment = finder.shade(crossing, world_direction);
    sum.add(fragment.color, fragment.opacity);
    ++layers;
    if (std::abs(sum.transmittance) < stop_below) break;
  }
  return {sum.over(background), sum.transmittance, layers};
}

}  // namespace pellucid::groundtruth
