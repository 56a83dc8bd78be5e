// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "groundtruth/rays/eye_side.h"
#include "groundtruth/shapes/crossing_geometry.h"
#include "groundtruth/shapes/line_segments.h"

namespace pellucid::groundtruth {

/// A TubeGeometry holds lines as round tubes. The tube of a line is one closed solid: what a ball
/// fills that runs along it, its radius that of the points and linear between them. A segment of
/// one radius is a cylinder with a ball at either end, another one a cone-sphere (see
/// round_solids.h). A ray enters the solid (Crossing::v < 0) and leaves it (v > 0) an even number
/// of times, however the line bends; where the line meets itself, so does the solid. A segment has
/// a chord or has none, and the chords of a line's segments are united. Crossing::u is the place
/// along the segment, in [0, 1], of the ball that touches there; Crossing::v is n · v, n the outer
/// normal, v the ray's direction.
/// A box holds a group of segments.
class TubeGeometry final : public CrossingGeometry {
 public:
  /// `before` is as make_geometry() takes it.
  TubeGeometry(const scene::LineObject& lines, std::uint32_t index, const GeometryContext& context,
               const TubeGeometry* before = nullptr);

  std::uint32_t box_count() const override { return segments_.groups().count(); }
  Box3 box(std::uint32_t group) const override;
  void cross(std::uint32_t group, const RayPacket& packet, std::uint32_t lanes) const override;
  bool is_union() const override { return true; }
  std::uint32_t solid(const Crossing& crossing) const override {
    return segments_.line(crossing.primitive);
  }
  Fragment shade(const Crossing& crossing, const Vec3& world_direction) const override;
  double importance(const Crossing& crossing) const override;
  double largest_coordinate() const override { return 0; }
  std::uint64_t bytes() const override { return segments_.bytes(); }

 private:
  void cross_segment(std::uint32_t segment, const SceneRay& ray,
                     std::vector<Crossing>& crossings) const;
  /// Returns the ball around a point, in view coordinates.
  Ball ball(std::uint32_t point) const;

  const geometry::LineSet& set_;
  const scene::Radii& radius_;
  std::uint32_t index_;
  const ViewFrame& frame_;
  scene::Lighting lighting_;
  LineSegments segments_;
};

}  // namespace pellucid::groundtruth
