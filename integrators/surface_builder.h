#pragma once

#include <cstdint>

#include "geometry/triangle_mesh.h"
#include "integrators/front_particle.h"

namespace pellucid {

/// Collects what the integrators emit. Flat arrays, because a half-edge structure would cost more
/// than the integration itself (docs/integrators.md).
class SurfaceBuilder {
 public:
  SurfaceBuilder(double start_time, bool with_normals);

  std::uint32_t add_vertex(const FrontPoint& point, double s);
  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);

  std::size_t triangle_count() const { return triangles_.size(); }
  double newest_t() const { return t_.empty() ? 0 : t_.back(); }
  std::uint64_t bytes() const;
  /// Hands the mesh over and leaves the builder empty.
  TriangleMesh finish();

 private:
  void reserve_vertices(std::size_t count);
  void fill_missing_normals();

  double start_time_;
  bool with_normals_;
  std::vector<Vec3> positions_, normals_;
  std::vector<double> s_, t_, speed_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
};

}  // namespace pellucid
