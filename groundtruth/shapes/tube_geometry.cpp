// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/shapes/tube_geometry.h"

#include <algorithm>
#include <cmath>

#include "groundtruth/shapes/round_solids.h"

namespace pellucid::groundtruth {

TubeGeometry::TubeGeometry(const scene::LineObject& lines, std::uint32_t index,
                           const GeometryContext& context)
    : set_(lines.set),
      radius_(lines.radius),
      index_(index),
      frame_(context.frame),
      lighting_(context.lighting),
      segments_(lines.set) {}

Ball TubeGeometry::ball(std::uint32_t point) const {
  return {frame_.from_world(set_.positions[point]), radius_.at(point) * frame_.units_per_length()};
}

Box3 TubeGeometry::box(std::uint32_t segment) const {
  const std::uint32_t i = segments_.first_point(segment);
  Box3 box;
  for (const Ball& end : {ball(i), ball(i + 1)}) {
    box.extend(end.center - end.radius);
    box.extend(end.center + end.radius);
  }
  return box;
}

void TubeGeometry::cross(std::uint32_t segment, const SceneRay& ray,
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
