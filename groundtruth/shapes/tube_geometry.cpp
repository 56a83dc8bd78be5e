// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/shapes/tube_geometry.h"

#include <algorithm>
#include <cmath>

#include "groundtruth/shapes/round_solids.h"

namespace pellucid::groundtruth {
namespace {

/// Where on the segment from -half to +half lies the point nearest to x: -1 … 1.
double nearest_on_axis(const Vec3& x, const Vec3& half) {
  const double squared = glm::dot(half, half);
  return squared > 0 ? std::clamp(glm::dot(x, half) / squared, -1.0, 1.0) : 0;
}

}  // namespace

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
  // From the same end whichever is stored first, so that depths are the same to the last bit.
  auto [a, b] = ends(segment);
  const bool backwards = in_coordinate_order(b, a);
  if (backwards) std::swap(a, b);
  const Vec3 half = 0.5 * (b - a);
  const LocalRay local(ray, a + half);
  const auto chord = capsule_chord(local, half, radius_);
  if (!chord) return;
  const SolidDepths depths = solid_depths(ray, local, *chord, [&] {
    const std::uint32_t i = segments_.first_point(segment);
    return eye_side(frame_, ray.picture, set_.positions[i], set_.positions[i + 1], radius_);
  });
  const auto add = [&](double t, double depth, double side) {
    const Vec3 x = local.at(t);
    const double axis = nearest_on_axis(x, half);
    const double cosine = glm::dot(x - axis * half, local.direction) / radius_;
    crossings.push_back({depth, 0.5 + 0.5 * (backwards ? -axis : axis), std::copysign(cosine, side),
                         index_, segment});
  };
  add(chord->begin, depths.enters, -1);
  add(chord->end, depths.leaves, 1);
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
