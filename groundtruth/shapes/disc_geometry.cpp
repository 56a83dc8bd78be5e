// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/shapes/disc_geometry.h"

#include <cmath>

#include "groundtruth/shapes/triangle_geometry.h"

namespace pellucid::groundtruth {

DiscGeometry::DiscGeometry(const scene::PointObject& points, std::uint32_t index,
                           const GeometryContext& context, const PointGeometry* before)
    : PointGeometry(points, index, context, before),
      largest_(points.radius.largest() * context.frame.units_per_length()) {
  for (std::uint32_t k = 0; k < points.set.positions.size(); ++k)
    largest_ = std::max(largest_, size_of(center(k)));
}

Box3 DiscGeometry::point_box(std::uint32_t point) const {
  const Vec3 c = center(point), reach(radius(point), radius(point), 0);
  return {c - reach, c + reach};
}

void DiscGeometry::cross_point(std::uint32_t point, const SceneRay& ray,
                               std::vector<Crossing>& crossings) const {
  const Vec3 c = center(point);
  const double r = radius(point);
  double squared = 0;
  if (r == 0 || c.z <= 0 || !ray.predicate.crosses_disc(c, r, squared)) return;
  const double facing = std::sqrt(std::max(0.0, 1 - squared / (r * r)));
  crossings.push_back({c.z, 0, facing, object_index(), point});
}

double DiscGeometry::exact_depth(const Crossing& crossing, const PictureRay&) const {
  return point_depth(frame(), world_center(crossing.primitive));
}

}  // namespace pellucid::groundtruth
