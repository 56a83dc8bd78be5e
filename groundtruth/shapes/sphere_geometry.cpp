// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/shapes/sphere_geometry.h"

#include <cmath>

#include "groundtruth/shapes/round_solids.h"
#include "groundtruth/shapes/vertex_blend.h"

namespace pellucid::groundtruth {

SphereGeometry::SphereGeometry(const scene::PointObject& points, std::uint32_t index,
                               const GeometryContext& context)
    : set_(points.set),
      index_(index),
      frame_(context.frame),
      lighting_(context.lighting),
      radius_(points.radius * frame_.units_per_length()) {
  check_count(set_.positions.size(), "points");
}

std::uint32_t SphereGeometry::box_count() const {
  return static_cast<std::uint32_t>(set_.positions.size());
}

Box3 SphereGeometry::box(std::uint32_t point) const {
  const Vec3 c = center(point);
  return {c - radius_, c + radius_};
}

void SphereGeometry::cross(std::uint32_t point, const SceneRay& ray,
                           std::vector<Crossing>& crossings) const {
  const LocalRay local(ray, center(point));
  const auto chord = ball_chord(local, Vec3(0), radius_);
  if (!chord) return;
  // At the ends of the chord n · v is half its length over the radius.
  const double cosine = 0.5 * (chord->end - chord->begin) / radius_;
  crossings.push_back({local.depth(chord->begin), 0, -cosine, index_, point});
  crossings.push_back({local.depth(chord->end), 0, cosine, index_, point});
}

Fragment SphereGeometry::shade(const Crossing& crossing, const Vec3&) const {
  Fragment fragment = point_blend(crossing).fragment(set_);
  fragment.color = scene::lit(lighting_, fragment.color, std::abs(crossing.v));
  return fragment;
}

double SphereGeometry::importance(const Crossing& crossing) const {
  return point_blend(crossing).importance(set_);
}

}  // namespace pellucid::groundtruth
