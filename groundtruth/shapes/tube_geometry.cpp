// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/shapes/tube_geometry.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "groundtruth/shapes/round_solids.h"

namespace pellucid::groundtruth {

TubeGeometry::TubeGeometry(const scene::LineObject& lines, std::uint32_t index,
                           const GeometryContext& context, const TubeGeometry* before)
    : set_(lines.set),
      radius_(lines.radius),
      index_(index),
      frame_(context.frame),
      lighting_(context.lighting),
      segments_(lines.set, frame_, before ? &before->segments_ : nullptr) {}

Ball TubeGeometry::ball(std::uint32_t point) const {
  return {frame_.from_world(set_.positions[point]), radius_.at(point) * frame_.units_per_length()};
}

Box3 TubeGeometry::box(std::uint32_t group) const {
  const SegmentGroups& groups = segments_.groups();
  const std::uint32_t first = segments_.first_point(groups.begin(group));
  const std::uint32_t count = groups.end(group) - groups.begin(group) + 1;  // points
  Box3 box;
  for (std::uint32_t i = first; i < first + count; ++i) {
    const Ball at = ball(i);
    box.extend(at.center - at.radius);
    box.extend(at.center + at.radius);
  }
  return box;
}

void TubeGeometry::cross(std::uint32_t group, const RayPacket& packet, std::uint32_t lanes) const {
  const SegmentGroups& groups = segments_.groups();
  for (std::uint32_t s = groups.begin(group); s < groups.end(group); ++s) {
    const std::uint32_t first = segments_.first_point(s);
    const Ball a = ball(first), b = ball(first + 1);
    const double reach = 0.5 * glm::distance(a.center, b.center) + std::max(a.radius, b.radius);
    for (std::uint32_t near = packet.predicate.may_meet(0.5 * (a.center + b.center), reach, lanes);
         near != 0; near &= near - 1) {
      const auto i = std::size_t(std::countr_zero(near));
      cross_segment(s, packet.rays[i], *packet.crossings[i]);
    }
  }
}

void TubeGeometry::cross_segment(std::uint32_t segment, const SceneRay& ray,
                                 std::vector<Crossing>& crossings) const {
  const std::uint32_t i = segments_.first_point(segment);
  const Ball a = ball(i), b = ball(i + 1);
  const auto met = cone_sphere_ends(ray, a, b);
  if (!met) return;
  const SolidDepths depths = solid_depths(ray, *met, [&] {
    return eye_side(frame_, ray.picture, {set_.positions[i], a.radius},
                    {set_.positions[i + 1], b.radius});
  });
  const auto add = [&](const SolidEnd& end, double depth, double side) {
    crossings.push_back(
        {depth, 0.5 + 0.5 * end.along, std::copysign(end.cosine, side), index_, segment});
  };
  add(met->enters, depths.enters, -1);
  add(met->leaves, depths.leaves, 1);
}

Fragment TubeGeometry::shade(const Crossing& crossing, const Vec3&) const {
  Fragment fragment = segments_.blend(crossing.primitive, crossing.u).fragment(set_);
  fragment.color = scene::lit(lighting_, fragment.color, std::min(1.0, std::abs(crossing.v)));
  return fragment;
}

double TubeGeometry::importance(const Crossing& crossing) const {
  return segments_.blend(crossing.primitive, crossing.u).importance(set_);
}

}  // namespace pellucid::groundtruth
