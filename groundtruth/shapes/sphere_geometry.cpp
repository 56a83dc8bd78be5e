// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/shapes/sphere_geometry.h"

#include "groundtruth/shapes/round_solids.h"

namespace pellucid::groundtruth {

Box3 SphereGeometry::point_box(std::uint32_t point) const {
  const Vec3 c = center(point);
  return {c - radius(point), c + radius(point)};
}

void SphereGeometry::cross_point(std::uint32_t point, const SceneRay& ray,
                                 std::vector<Crossing>& crossings) const {
  const auto met = ball_ends(ray, center(point), radius(point));
  if (!met) return;
  const SolidDepths depths = solid_depths(ray, *met, [&] {
    const Vec3& center = world_center(point);
    return eye_side(frame(), ray.picture, {center, radius(point)}, {center, radius(point)});
  });
  crossings.push_back({depths.enters, 0, met->enters.cosine, object_index(), point});
  crossings.push_back({depths.leaves, 0, met->leaves.cosine, object_index(), point});
}

}  // namespace pellucid::groundtruth
