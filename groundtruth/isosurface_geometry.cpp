#include "groundtruth/isosurface_geometry.h"

#include <cmath>

#include "fields/surface_cells.h"
#include "groundtruth/level_ray.h"

namespace pellucid {

IsosurfaceGeometry::IsosurfaceGeometry(const Isosurface& surface, std::uint32_t index,
                                       const GeometryContext& context)
    : surface_(surface),
      index_(index),
      lit_(context.lighting != Lighting::none),
      frame_(context.frame),
      view_origin_(frame_.from_world(Vec3(0))),
      cells_(surface_cells(*surface.field, surface.value)) {
  check_count(cells_.size(), "cells of an isosurface");
  // A rotation times a scale: its inverse is its transpose over the scale squared.
  const Mat3 view_from_world(frame_.vector_from_world(Vec3(1, 0, 0)),
                             frame_.vector_from_world(Vec3(0, 1, 0)),
                             frame_.vector_from_world(Vec3(0, 0, 1)));
  const double scale = frame_.units_per_length();
  world_from_view_ = glm::transpose(view_from_world) / (scale * scale);
}

Box3 IsosurfaceGeometry::box(std::uint32_t k) const {
  const Box3 world = cell_box(*surface_.field, cells_[k]);
  Box3 view;
  for (int corner = 0; corner < 8; ++corner)
    view.extend(frame_.from_world({corner & 1 ? world.max.x : world.min.x,
                                   corner & 2 ? world.max.y : world.min.y,
                                   corner & 4 ? world.max.z : world.min.z}));
  return view;
}

void IsosurfaceGeometry::cross(std::uint32_t k, const SceneRay& ray,
                               std::vector<Crossing>& crossings) const {
  const WorldRay world{world_from_view_ * (ray.start - view_origin_),
                       world_from_view_ * ray.direction};
  thread_local std::vector<double> at;
  at.clear();
  append_level_crossings(*surface_.field, surface_.value, cells_[k], world, at);
  for (const double t : at) {
    const Vec3 x = world.at(t);
    if (surface_.cuts_away(x)) continue;
    double cosine = 1;
    if (lit_) {
      const Vec3 gradient = surface_.field->gradient(x).value_or(Vec3(0));
      const double size = glm::length(gradient) * glm::length(world.direction);
      cosine = size > 0 ? glm::dot(gradient, world.direction) / size : 1;
    }
    crossings.push_back({ray.start.z + t * ray.direction.z, 0, cosine, index_, k});
  }
}

Fragment IsosurfaceGeometry::shade(const Crossing& crossing, const Vec3&) const {
  const Rgba& color = surface_.corners.colors.front();
  return {Vec3(color) * (lit_ ? std::abs(crossing.v) : 1), color.a};
}

}  // namespace pellucid
