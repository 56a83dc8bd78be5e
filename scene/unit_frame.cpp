#include "scene/unit_frame.h"

#include <algorithm>
#include <cmath>

namespace pellucid {

UnitFrame unit_frame(const Scene& scene) {
  const Box3 box = scene.bounds();
  if (box.empty()) return {};
  const Vec3 half = 0.5 * box.max - 0.5 * box.min;
  const double largest = std::max({half.x, half.y, half.z});
  if (!(largest > 0)) return {box.center(), 1};
  return {box.center(), std::exp2(-std::ceil(std::log2(largest)))};
}

}  // namespace pellucid
