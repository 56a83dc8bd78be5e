// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/shapes/point_geometry.h"

#include <bit>
#include <cmath>

#include "groundtruth/shapes/vertex_blend.h"

namespace pellucid::groundtruth {

PointGeometry::PointGeometry(const scene::PointObject& points, std::uint32_t index,
                             const GeometryContext& context, const PointGeometry* before)
    : set_(points.set),
      radius_(points.radius.of(0, points.set.positions.size())),
      units_per_length_(context.frame.units_per_length()),
      index_(index),
      frame_(context.frame),
      lighting_(context.lighting) {
  check_count(set_.positions.size(), "points");
  if (before && before->groups_->points() == set_.positions.size())
    groups_ = before->groups_;
  else
    groups_ = std::make_shared<const PointGroups>(set_.positions);
}

Box3 PointGeometry::box(std::uint32_t group) const {
  Box3 box;
  for (const std::uint32_t point : groups_->of(group)) {
    const Box3 of_point = point_box(point);
    box.extend(of_point.min);
    box.extend(of_point.max);
  }
  return box;
}

void PointGeometry::cross(std::uint32_t group, const RayPacket& packet, std::uint32_t lanes) const {
  for (const std::uint32_t point : groups_->of(group))
    for (std::uint32_t rest = packet.predicate.may_meet(center(point), radius(point), lanes);
         rest != 0; rest &= rest - 1) {
      const auto i = std::size_t(std::countr_zero(rest));
      cross_point(point, packet.rays[i], *packet.crossings[i]);
    }
}

Fragment PointGeometry::shade(const Crossing& crossing, const Vec3&) const {
  Fragment fragment = point_blend(crossing).fragment(set_);
  fragment.color = scene::lit(lighting_, fragment.color, std::abs(crossing.v));
  return fragment;
}

double PointGeometry::importance(const Crossing& crossing) const {
  return point_blend(crossing).importance(set_);
}

}  // namespace pellucid::groundtruth
