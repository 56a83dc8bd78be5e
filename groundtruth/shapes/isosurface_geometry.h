// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fields/levels/level_field.h"
#include "groundtruth/levels/level_ray.h"
#include "groundtruth/shapes/crossing_geometry.h"

namespace pellucid::groundtruth {

/// An IsosurfaceGeometry has what all ways of crossing an isosurface have in common: its place in
/// the view and its light. Crossing::v is n · v, n the unit gradient and v the ray's direction;
/// Crossing::u has the bits of two floats: the place on the colour map, where there is one, and the
/// opacity.
class IsosurfaceGeometry : public RayByRayGeometry {
 public:
  IsosurfaceGeometry(const scene::Isosurface& surface, std::uint32_t index,
                     const GeometryContext& context);

  Fragment shade(const Crossing& crossing, const Vec3& world_direction) const override;
  double importance(const Crossing&) const override { return 0; }
  double largest_coordinate() const override { return 0; }

 protected:
  const scene::Isosurface& surface() const { return surface_; }
  const fields::LevelField& field() const { return *surface_.field; }
  /// Returns the box in view coordinates around one in the world.
  Box3 view_box(const Box3& world) const;
  /// Returns the ray in world coordinates, with the same parameter.
  WorldRay to_world(const SceneRay& ray) const;
  /// Appends the crossing at the ray's parameter t, unless the surface has a hole there; returns
  /// its opacity.
  std::optional<float> append(const SceneRay& ray, const WorldRay& world, double t,
                              std::uint32_t primitive, std::vector<Crossing>& crossings) const;

 private:
  const scene::Isosurface& surface_;
  std::uint32_t index_;
  scene::Lighting lighting_;
  const ViewFrame& frame_;
  Mat3 world_from_view_;  // of vectors
  Vec3 view_origin_;      // of the world's origin
};

}  // namespace pellucid::groundtruth
