// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "groundtruth/shapes/point_geometry.h"

namespace pellucid::groundtruth {

/// A DiscGeometry holds points as discs parallel to the picture, crossed at their centre's depth.
/// Crossing::v is |n · v| of the sphere that a disc stands for: √(1 - c²) at the fraction c of its
/// radius.
class DiscGeometry final : public PointGeometry {
 public:
  DiscGeometry(const scene::PointObject& points, std::uint32_t index,
               const GeometryContext& context, const PointGeometry* before = nullptr);

  double exact_depth(const Crossing& crossing, const PictureRay& ray) const override;
  double depth_error(const Crossing&, const SceneRay& ray) const override {
    return ray.doubt.rounding;
  }
  double largest_coordinate() const override { return largest_; }

 private:
  Box3 point_box(std::uint32_t point) const override;
  void cross_point(std::uint32_t point, const SceneRay& ray,
                   std::vector<Crossing>& crossings) const override;

  double largest_;
};

}  // namespace pellucid::groundtruth
