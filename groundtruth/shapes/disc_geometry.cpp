// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/shapes/disc_geometry.h"

#include <cmath>

#include "groundtruth/shapes/triangle_geometry.h"
#include "groundtruth/shapes/vertex_blend.h"

namespace pellucid::groundtruth {

DiscGeometry::DiscGeometry(const scene::PointObject& points, std::uint32_t index,
                           const GeometryContext& context)
    : set_(points.set),
      index_(index),
      frame_(context.frame),
      lighting_(context.lighting),
      radius_(points.radius * frame_.units_per_length()),
      largest_(radius_) {
  check_count(set_.positions.size(), "points");
  for (std::uint32_t k = 0; k < box_count(); ++k) largest_ = std::max(largest_, size_of(center(k)));
}

std::uint32_t DiscGeometry::box_count() const {
  return static_cast<std::uint32_t>(set_.positions.size());
}

Box3 DiscGeometry::box(std::uint32_t point) const {
  const Vec3 c = center(point), reach(radius_, radius_, 0);
  return {c - reach, c + reach};
}

void DiscGeometry::cross(std::uint32_t point, const SceneRay& ray,
                         std::vector<Crossing>& crossings) const {
  const Vec3 c = center(point);
  double squared = 0;
  if (c.z <= 0 || !ray.predicate.crosses_disc(c, radius_, squared)) return;
  const double facing = std::sqrt(std::max(0.0, 1 - squared / (radius_ * radius_)));
  crossings.push_back({c.z, 0, facing, index_, point});
}

Fragment DiscGeometry::shade(const Crossing& crossing, const Vec3&) const {
  Fragment fragment = point_blend(crossing).fragment(set_);
  fragment.color = scene::lit(lighting_, fragment.color, crossing.v);
  return fragment;
}

double DiscGeometry::importance(const Crossing& crossing) const {
  return point_blend(crossing).importance(set_);
}

}  // namespace pellucid::groundtruth
