// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "groundtruth/shapes/point_geometry.h"

namespace pellucid::groundtruth {

/// A SphereGeometry holds points as spheres, each a solid of its own: the ray crosses where it
/// enters (Crossing::v < 0) and where it leaves (v > 0), or not at all. Crossing::v is n · v, n the
/// sphere's outer normal and v the ray's direction.
class SphereGeometry final : public PointGeometry {
 public:
  SphereGeometry(const scene::PointObject& points, std::uint32_t index,
                 const GeometryContext& context, const PointGeometry* before = nullptr)
      : PointGeometry(points, index, context, before) {}

  double largest_coordinate() const override { return 0; }

 private:
  Box3 point_box(std::uint32_t point) const override;
  void cross_point(std::uint32_t point, const SceneRay& ray,
                   std::vector<Crossing>& crossings) const override;
};

}  // namespace pellucid::groundtruth
