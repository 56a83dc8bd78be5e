// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/sums/composite.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "groundtruth/sums/front_to_back.h"

namespace pellucid::groundtruth {

Composite composite(const CrossingFinder& finder, std::span<const Crossing> crossings,
                    const Vec3& background, const Vec3& world_direction, double stop_below) {
  // Shaded some at a time: the processor fetches the vertices of several together, and little is
  // shaded in vain behind where the sum ends.
  std::array<Fragment, 16> shaded;
  FrontToBack sum;
  std::uint32_t layers = 0;
  while (!crossings.empty()) {
    const auto some = crossings.first(std::min(shaded.size(), crossings.size()));
    crossings = crossings.subspan(some.size());
    finder.shade(some, world_direction, shaded);
    for (const Fragment& fragment : std::span(shaded).first(some.size())) {
      sum.add(fragment.color, fragment.opacity);
      ++layers;
      if (std::abs(sum.transmittance) < stop_below)
        return {sum.over(background), sum.transmittance, layers};
    }
  }
  return {sum.over(background), sum.transmittance, layers};
}

}  // namespace pellucid::groundtruth
