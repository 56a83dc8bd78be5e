#include "groundtruth/composite.h"

namespace pellucid {

Composite composite(const CrossingFinder& finder, std::span<const Crossing> crossings,
                    const Vec3& background, const Vec3& world_direction) {
  Composite sum{Vec3(0), 1};
  for (const Crossing& crossing : crossings) {
    const Fragment fragment = finder.shade(crossing, world_direction);
    sum.color += sum.transmittance * fragment.opacity * fragment.color;
    sum.transmittance *= 1 - fragment.opacity;
  }
  sum.color += sum.transmittance * background;
  return sum;
}

}  // namespace pellucid
