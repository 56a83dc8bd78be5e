// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

#include "geometry/triangle_mesh.h"
#include "integrators/front/front_particle.h"
#include "integrators/paths/seed_curve.h"
#include "integrators/surface_integrator.h"

namespace pellucid::integrators {

/// Collects what the integrators emit. Flat arrays, of which the half-edge mesh is built at once
/// when the fronts are through: half-edges that grow with them would cost more than the integration
/// itself (docs/integrators.md).
class SurfaceBuilder {
 public:
  /// `request` must outlive it.
  SurfaceBuilder(const SurfaceRequest& request, bool with_normals);

  std::uint32_t add_vertex(const FrontPoint& point, double s);
  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);

  std::size_t triangle_count() const { return triangles_.size(); }
  std::size_t vertex_count() const { return positions_.size(); }
  bool has_normals() const { return with_normals_; }
  std::vector<std::array<std::uint32_t, 3>>& triangles() { return triangles_; }
  const std::vector<std::array<std::uint32_t, 3>>& triangles() const { return triangles_; }
  std::span<const Vec3> positions() const { return positions_; }
  const Vec3& position(std::uint32_t vertex) const { return positions_[vertex]; }
  const Vec3& normal(std::uint32_t vertex) const { return normals_[vertex]; }
  /// Not so where it stands still, nor on a crease, which starts at a corner of the seed curve.
  bool has_one_normal(std::uint32_t vertex) const;
  /// A vertex at rest stands for its particle's whole way, not for one (s, t) alone.
  bool rests(std::uint32_t vertex) const { return speed_[vertex] == 0; }
  /// Twice the triangle's area in (s, t): > 0 when it is not turned over.
  double parameter_area(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;
  /// (s, t) halfway between two vertices.
  std::pair<double, double> halfway(std::uint32_t a, std::uint32_t b) const;
  double newest_t() const { return t_.empty() ? 0 : t_.back(); }
  std::uint64_t bytes() const;
  /// Drops vertices that no triangle has.
  void drop_unused_vertices();
  /// Hands the mesh over and leaves the builder empty.
  geometry::TriangleMesh finish();

 private:
  double s_step(std::uint32_t a, std::uint32_t b) const;
  void reserve_vertices(std::size_t count);

  double start_time_;
  bool path_;
  bool with_normals_;
  const SeedCurve& curve_;
  std::vector<Vec3> positions_, normals_;
  std::vector<double> s_, t_, speed_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
};

}  // namespace pellucid::integrators
