// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/shapes/isosurface_geometry.h"

#include <bit>
#include <cmath>

namespace pellucid::groundtruth {
namespace {

/// In a Crossing. In this order the double is a number: an opacity's exponent is no NaN's.
struct Look {
  float color_fraction = 0;
  float opacity = 0;
};

}  // namespace

IsosurfaceGeometry::IsosurfaceGeometry(const scene::Isosurface& surface, std::uint32_t index,
                                       const GeometryContext& context)
    : surface_(surface),
      index_(index),
      lighting_(context.lighting),
      frame_(context.frame),
      view_origin_(frame_.from_world(Vec3(0))) {
  // A rotation times a scale: its inverse is its transpose over the scale squared.
  const Mat3 view_from_world(frame_.vector_from_world(Vec3(1, 0, 0)),
                             frame_.vector_from_world(Vec3(0, 1, 0)),
                             frame_.vector_from_world(Vec3(0, 0, 1)));
  const double scale = frame_.units_per_length();
  world_from_view_ = glm::transpose(view_from_world) / (scale * scale);
}

Box3 IsosurfaceGeometry::view_box(const Box3& world) const {
  Box3 view;
  for (const Vec3& corner : scene::corners_of(world).positions)
    view.extend(frame_.from_world(corner));
  return view;
}

WorldRay IsosurfaceGeometry::to_world(const SceneRay& ray) const {
  return {world_from_view_ * (ray.start - view_origin_), world_from_view_ * ray.direction};
}

std::optional<float> IsosurfaceGeometry::append(const SceneRay& ray, const WorldRay& world,
                                                double t, std::uint32_t primitive,
                                                std::vector<Crossing>& crossings) const {
  const Vec3 x = world.at(t);
  if (surface_.cuts_away(x)) return std::nullopt;
  double cosine = 1;
  if (lighting_ != scene::Lighting::none) {
    const Vec3 gradient = field().gradient(x).value_or(Vec3(0));
    const double size = glm::length(gradient) * glm::length(world.direction);
    cosine = size > 0 ? glm::dot(gradient, world.direction) / size : 1;
  }
  const Look look{
      surface_.coloring ? float(surface_.coloring->scalar.fraction(x)) : 0,
      surface_.fading ? surface_.fading->opacity(x) : surface_.corners.colors.front().a};
  crossings.push_back(
      {ray.start.z + t * ray.direction.z, std::bit_cast<double>(look), cosine, index_, primitive});
  return look.opacity;
}

Fragment IsosurfaceGeometry::shade(const Crossing& crossing, const Vec3&) const {
  const auto look = std::bit_cast<Look>(crossing.u);
  const Vec3 color = surface_.coloring ? surface_.coloring->color(look.color_fraction)
                                       : Vec3(surface_.corners.colors.front());
  return {scene::lit(lighting_, color, std::abs(crossing.v)), look.opacity};
}

}  // namespace pellucid::groundtruth
