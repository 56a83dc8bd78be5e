// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "groundtruth/shapes/crossing_geometry.h"

namespace pellucid::groundtruth {

/// A SphereGeometry holds points as spheres, each a solid of its own: the ray crosses where it
/// enters (Crossing::v < 0) and where it leaves (v > 0), or not at all. Crossing::v is n · v, n the
/// sphere's outer normal and v the ray's direction.
class SphereGeometry final : public RayByRayGeometry {
 public:
  SphereGeometry(const scene::PointObject& points, std::uint32_t index,
                 const GeometryContext& context);

  std::uint32_t box_count() const override;
  Box3 box(std::uint32_t point) const override;
  void cross(std::uint32_t point, const SceneRay& ray,
             std::vector<Crossing>& crossings) const override;
  Fragment shade(const Crossing& crossing, const Vec3& world_direction) const override;
  double importance(const Crossing& crossing) const override;
  double largest_coordinate() const override { return 0; }
  std::uint64_t bytes() const override { return 0; }

 private:
  Vec3 center(std::uint32_t point) const { return frame_.from_world(set_.positions[point]); }

  const geometry::PointSet& set_;
  std::uint32_t index_;
  const ViewFrame& frame_;
  scene::Lighting lighting_;
  double radius_;  // units
};

}  // namespace pellucid::groundtruth
