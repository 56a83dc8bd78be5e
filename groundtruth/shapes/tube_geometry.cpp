// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/shapes/tube_geometry.h"

#include <algorithm>
#include <cmath>

#include "groundtruth/shapes/round_solids.h"

namespace pellucid::groundtruth {

TubeGeometry::TubeGeometry(const scene::LineObject& lines, std::uint32_t index,
                           const GeometryContext& context)
    : set_(lines.set),
      index_(index),
      frame_(context.frame),
      lighting_(context.lighting),
      radius_(lines.radius * frame_.units_per_length()),
      segments_(lines.set) {}

std::array<Vec3, 2> TubeGeometry::ends(std::uint32_t segment) const {
  const std::uint32_t i = segments_.first_point(segment);
  return {frame_.from_world(set_.positions[i]), frame_.from_world(set_.positions[i + 1])};
}

Box3 TubeGeometry::box(std::uint32_t segment) const {
  const auto [a, b] = ends(segment);
  return {glm::min(a, b) - radius_, glm::max(a, b) + radius_};
}

void TubeGeometry::cross(std::uint32_t segment, const SceneRay& ray,
                         std::vector<Crossing>& crossings) const {
  const auto [a, b] = ends(segment);
  const auto met = capsule_ends(ray, a, b, radius_);
  if (!met) return;
  const SolidDepths depths = solid_depths(ray, *met, [&] {
    const std::uint32_t i = segments_.first_point(segment);
    return eye_side(frame_, ray.picture, set_.positions[i], set_.positions[i + 1], radius_);
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
