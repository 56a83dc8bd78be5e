// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "groundtruth/shapes/crossing_geometry.h"
#include "groundtruth/shapes/line_segments.h"

namespace pellucid::groundtruth {

/// A RibbonGeometry holds lines as strips that face the eye (see scene/view/ribbon.h): exact
/// triangles over corners that neighbouring segments share. Crossing::u and v are the weights of a
/// triangle's second and third corner. A box holds a group of segments. Of a line's points only the
/// half widths are kept; corners are made where they are needed.
class RibbonGeometry final : public CrossingGeometry {
 public:
  /// `before` is as make_geometry() takes it.
  RibbonGeometry(const scene::LineObject& lines, std::uint32_t index,
                 const GeometryContext& context, const RibbonGeometry* before = nullptr);

  std::uint32_t box_count() const override { return segments_.groups().count(); }
  Box3 box(std::uint32_t group) const override;
  void cross(std::uint32_t group, const RayPacket& packet, std::uint32_t lanes) const override;
  double exact_depth(const Crossing& crossing, const PictureRay& ray) const override;
  double depth_error(const Crossing& crossing, const SceneRay& ray) const override;
  Fragment shade(const Crossing& crossing, const Vec3& world_direction) const override;
  double importance(const Crossing& crossing) const override;
  double largest_coordinate() const override { return largest_; }
  std::uint64_t bytes() const override;

 private:
  std::array<Vec3, 4> corners(std::uint32_t segment) const;
  std::array<Vec3, 3> triangle_of(const Crossing& crossing) const;

  const geometry::LineSet& set_;
  std::uint32_t index_;
  const ViewFrame& frame_;
  scene::Lighting lighting_;
  double largest_ = 0;
  LineSegments segments_;
  std::vector<Vec3> half_widths_;  // of each point
};

}  // namespace pellucid::groundtruth
