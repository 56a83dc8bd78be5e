// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "groundtruth/shapes/crossing_geometry.h"

namespace pellucid::groundtruth {

/// Appends to their lists the crossings of the packet's rays whose bit in `lanes` is set with the
/// flat triangle (a, b, c); u and v are the weights of b and c.
void cross_triangle(const Vec3& a, const Vec3& b, const Vec3& c, std::uint32_t object,
                    std::uint32_t primitive, const RayPacket& packet, std::uint32_t lanes);

/// Returns the size of the largest coordinate.
double size_of(const Vec3& x);

/// A TriangleGeometry holds a mesh; Crossing::u and v are the weights of the triangle's second and
/// third vertex. It keeps its vertices in view coordinates, where triangles that share one share
/// its rounding.
class TriangleGeometry final : public CrossingGeometry {
 public:
  /// `before` is as make_geometry() takes it.
  TriangleGeometry(const geometry::TriangleMesh& mesh, std::uint32_t index,
                   const GeometryContext& context, const TriangleGeometry* before = nullptr);

  std::uint32_t box_count() const override;
  Box3 box(std::uint32_t k) const override;
  void cross(std::uint32_t k, const RayPacket& packet, std::uint32_t lanes) const override;
  double exact_depth(const Crossing& crossing, const PictureRay& ray) const override;
  double depth_error(const Crossing& crossing, const SceneRay& ray) const override;
  Fragment shade(const Crossing& crossing, const Vec3& world_direction) const override;
  double importance(const Crossing& crossing) const override;
  bool repeats() const override { return any_slabs_; }
  double largest_coordinate() const override { return largest_; }
  std::uint64_t bytes() const override;

  std::uint32_t index() const { return index_; }                  // in Scene::objects
  std::span<const Vec3> positions() const { return positions_; }  // view coordinates
  const auto& triangles() const { return mesh_.triangles; }

 private:
  /// A Piece is what a box holds: one or two triangles, several small ones, or, where they are long
  /// and their box is mostly empty, the part of them in one of `slabs` equal slabs across the
  /// longest side of their box.
  struct Piece {
    std::uint32_t first;  // triangle
    std::uint8_t count, slab, slabs;
  };

  Box3 whole_box(const Piece& piece) const;
  Box3 box(const Piece& piece) const;
  double total_area(Piece piece) const;
  void add_pieces(std::uint32_t first, std::uint8_t count);
  void group_triangles();
  std::uint8_t small_group(std::uint32_t first) const;
  std::size_t grouped_triangles() const;

  const geometry::TriangleMesh& mesh_;
  std::uint32_t index_;
  const ViewFrame& frame_;
  scene::Lighting lighting_;
  double largest_ = 0;
  std::vector<Vec3> positions_;
  std::vector<Piece> pieces_;
  bool any_slabs_ = false;
};

}  // namespace pellucid::groundtruth
