// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/shapes/ribbon_geometry.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "groundtruth/shapes/triangle_geometry.h"
#include "groundtruth/shapes/vertex_blend.h"
#include "scene/view/ribbon.h"

namespace pellucid::groundtruth {
namespace {

/// Where on its segment a crossing lies.
struct RibbonPoint {
  double along;   // 0 at the segment's first point, 1 at its second
  double across;  // c: -1 … 1 from one rim to the other
};

/// From the corners of ribbon_triangles: (-w, +w, next +w) and (-w, next +w, next -w).
RibbonPoint ribbon_point(const Crossing& crossing) {
  const double u = crossing.u, v = crossing.v;
  return crossing.primitive % 2 == 0 ? RibbonPoint{v, 2 * (u + v) - 1}
                                     : RibbonPoint{std::min(u + v, 1.0), 2 * u - 1};
}

/// Of directions of any length; 0 where one has none.
double sine_between(const Vec3& p, const Vec3& q) {
  const double lengths = glm::length(p) * glm::length(q);
  return lengths > 0 ? glm::length(glm::cross(p, q)) / lengths : 0;
}

}  // namespace

RibbonGeometry::RibbonGeometry(const scene::LineObject& lines, std::uint32_t index,
                               const GeometryContext& context, const RibbonGeometry* before)
    : set_(lines.set),
      index_(index),
      frame_(context.frame),
      lighting_(context.lighting),
      segments_(lines.set, frame_, before ? &before->segments_ : nullptr) {
  const std::span<const Vec3> points(set_.positions);
  const scene::CameraFrame camera = scene::camera_frame(context.camera);
  half_widths_.reserve(points.size());
  std::vector<Vec3> of_line;
  for (std::size_t k = 0; k < set_.line_count(); ++k) {
    const auto line = points.subspan(set_.offsets[k], set_.offsets[k + 1] - set_.offsets[k]);
    scene::ribbon_half_widths(line, lines.radius.of(set_.offsets[k], line.size()), camera,
                              context.camera.projection, of_line);
    for (const Vec3& w : of_line) half_widths_.push_back(frame_.vector_from_world(w));
  }
  for (std::uint32_t s = 0; s < segments_.count(); ++s)
    for (const Vec3& corner : corners(s)) largest_ = std::max(largest_, size_of(corner));
}

/// x - w and x + w of the first point, then of the second.
std::array<Vec3, 4> RibbonGeometry::corners(std::uint32_t segment) const {
  const std::uint32_t i = segments_.first_point(segment);
  const Vec3 a = frame_.from_world(set_.positions[i]), b = frame_.from_world(set_.positions[i + 1]);
  return {a - half_widths_[i], a + half_widths_[i], b - half_widths_[i + 1],
          b + half_widths_[i + 1]};
}

Box3 RibbonGeometry::box(std::uint32_t group) const {
  const SegmentGroups& groups = segments_.groups();
  Box3 box;
  for (std::uint32_t s = groups.begin(group); s < groups.end(group); ++s)
    for (const Vec3& corner : corners(s)) box.extend(corner);
  return box;
}

void RibbonGeometry::cross(std::uint32_t group, const RayPacket& packet,
                           std::uint32_t lanes) const {
  const SegmentGroups& groups = segments_.groups();
  for (std::uint32_t s = groups.begin(group); s < groups.end(group); ++s) {
    const std::array<Vec3, 4> corner = corners(s);
    const Vec3 middle = 0.25 * (corner[0] + corner[1] + corner[2] + corner[3]);
    double reach = 0;
    for (const Vec3& x : corner) reach = std::max(reach, glm::distance(x, middle));
    const std::uint32_t near = packet.predicate.may_meet(middle, reach, lanes);
    if (near == 0) continue;
    const auto triangles = scene::ribbon_triangles(0);
    for (std::uint32_t j = 0; j < 2; ++j) {
      const auto& [a, b, c] = triangles[j];
      cross_triangle(corner[a], corner[b], corner[c], index_, 2 * s + j, packet, near);
    }
  }
}

std::array<Vec3, 3> RibbonGeometry::triangle_of(const Crossing& crossing) const {
  const std::array<Vec3, 4> corner = corners(crossing.primitive / 2);
  const auto [a, b, c] = scene::ribbon_triangles(0)[crossing.primitive % 2];
  return {corner[a], corner[b], corner[c]};
}

double RibbonGeometry::exact_depth(const Crossing& crossing, const PictureRay& ray) const {
  return view_plane_depth(ray, triangle_of(crossing));
}

double RibbonGeometry::depth_error(const Crossing& crossing, const SceneRay& ray) const {
  return groundtruth::depth_error(ray.picture, ray.doubt, ray.predicate.bound(),
                                  triangle_of(crossing));
}

Fragment RibbonGeometry::shade(const Crossing& crossing, const Vec3& world_direction) const {
  const std::uint32_t segment = crossing.primitive / 2;
  const auto [along, across] = ribbon_point(crossing);
  Fragment fragment = segments_.blend(segment, along).fragment(set_);
  if (lighting_ == scene::Lighting::none) return fragment;
  // |m · v| is the sine of the angle between v and the line.
  const double c = std::sqrt(std::max(0.0, 1 - across * across)) *
                   sine_between(segments_.direction(segment, along), world_direction);
  fragment.color = scene::lit(lighting_, fragment.color, c);
  return fragment;
}

double RibbonGeometry::importance(const Crossing& crossing) const {
  return segments_.blend(crossing.primitive / 2, ribbon_point(crossing).along).importance(set_);
}

std::uint64_t RibbonGeometry::bytes() const {
  return half_widths_.size() * sizeof(Vec3) + segments_.bytes();
}

}  // namespace pellucid::groundtruth
