// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "groundtruth/shapes/crossing_geometry.h"
#include "groundtruth/shapes/point_groups.h"

namespace pellucid::groundtruth {

/// A PointGeometry is what discs and spheres share: points of some radius, a primitive each, whose
/// crossings have in Crossing::v the cosine of the angle between ray and normal, in [-1, 1]. A box
/// holds a group of points.
class PointGeometry : public CrossingGeometry {
 public:
  std::uint32_t box_count() const final { return groups_->count(); }
  Box3 box(std::uint32_t group) const final;
  void cross(std::uint32_t group, const RayPacket& packet, std::uint32_t lanes) const final;
  Fragment shade(const Crossing& crossing, const Vec3& world_direction) const final;
  double importance(const Crossing& crossing) const final;
  std::uint64_t bytes() const final { return groups_->bytes(); }

 protected:
  /// `before` is as make_geometry() takes it. Throws InputError for 2^32 points or more.
  PointGeometry(const scene::PointObject& points, std::uint32_t index,
                const GeometryContext& context, const PointGeometry* before);

  /// Returns the box of a point's disc, or sphere.
  virtual Box3 point_box(std::uint32_t point) const = 0;
  /// Appends the ray's crossings with a point's disc, or sphere.
  virtual void cross_point(std::uint32_t point, const SceneRay& ray,
                           std::vector<Crossing>& crossings) const = 0;

  Vec3 center(std::uint32_t point) const { return frame_.from_world(world_center(point)); }
  const Vec3& world_center(std::uint32_t point) const { return set_.positions[point]; }
  const ViewFrame& frame() const { return frame_; }
  /// Returns how wide a point is drawn, in view units.
  double radius(std::uint32_t point) const { return radius_.at(point) * units_per_length_; }
  std::uint32_t object_index() const { return index_; }  // in Scene::objects

 private:
  const geometry::PointSet& set_;
  std::shared_ptr<const PointGroups> groups_;
  scene::RadiusSpan radius_;  // world
  double units_per_length_;
  std::uint32_t index_;
  const ViewFrame& frame_;
  scene::Lighting lighting_;
};

}  // namespace pellucid::groundtruth
