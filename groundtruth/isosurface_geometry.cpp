#include "groundtruth/isosurface_geometry.h"

#include <cmath>

namespace pellucid {

IsosurfaceGeometry::IsosurfaceGeometry(const Isosurface& surface, std::uint32_t index,
                                       const GeometryContext& context)
    : surface_(surface),
      index_(index),
      lit_(context.lighting != Lighting::none),
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
  for (const Vec3& corner : corners_of(world).positions) view.extend(frame_.from_world(corner));
  return view;
}

WorldRay IsosurfaceGeometry::to_world(const SceneRay& ray) const {
  return {world_from_view_ * (ray.start - view_origin_), world_from_view_ * ray.direction};
}

bool IsosurfaceGeometry::append(const SceneRay& ray, const WorldRay& world, double t,
                                std::uint32_t primitive, std::vector<Crossing>& crossings) const {
  const Vec3 x = world.at(t);
  if (surface_.cuts_away(x)) return false;
  double cosine = 1;
  if (lit_) {
    const Vec3 gradient = field().gradient(x).value_or(Vec3(0));
    const double size = glm::length(gradient) * glm::length(world.direction);
    cosine = size > 0 ? glm::dot(gradient, world.direction) / size : 1;
  }
  const double fraction = surface_.coloring ? surface_.coloring->fraction(x) : 0;
  crossings.push_back({ray.start.z + t * ray.direction.z, fraction, cosine, index_, primitive});
  return true;
}

Fragment IsosurfaceGeometry::shade(const Crossing& crossing, const Vec3&) const {
  const Rgba& own = surface_.corners.colors.front();
  const Vec3 color = surface_.coloring ? surface_.coloring->color(crossing.u) : Vec3(own);
  return {color * (lit_ ? std::abs(crossing.v) : 1), own.a};
}

}  // namespace pellucid
