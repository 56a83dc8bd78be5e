// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/sums/composite.h"

#include <cmath>

namespace pellucid::groundtruth {

Composite composite(const CrossingFinder& finder, std::span<const Crossing> crossings,
                    const Vec3& background, const Vec3& world_direction, double stop_below) {
  Composite sum{Vec3(0), 1, 0};
  for (const Crossing& crossing : crossings) {
    const Fragment fragment = finder.shade(crossing, world_direction);
    sum.color += sum.transmittance * fragment.opacity * fragment.color;
    sum.transmittance *= 1 - fragment.opacity;
    ++sum.layers;
    // Rounding may take the share of α = 1 an ulp below 0.
    if (std::abs(sum.transmittance) < stop_below) break;
  }
  sum.color += sum.transmittance * background;
  return sum;
}

}  // namespace pellucid::groundtruth
