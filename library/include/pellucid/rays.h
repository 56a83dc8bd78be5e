// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Every crossing of any ray with a triangle mesh, decided without rounding: an edge or a vertex
// that triangles share is crossed once, and a point is inside a closed mesh or it is not.

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <pellucid/export.h>

namespace pellucid {

/// A Point3 is a point or a direction: x, y, z.
using Point3 = std::array<double, 3>;

/// A RayCrossing is where a ray crosses a triangle (a, b, c): at origin + t · direction, which is
/// a + u (b - a) + v (c - a).
struct RayCrossing {
  double t, u, v;
  std::uint32_t triangle;  // of the mesh, from 0
  int side;                // 1: along (b - a) × (c - a); -1: against it
};

/// A MeshRays answers for rays of any origin and any direction but 0 which triangles of a mesh they
/// cross in front of their origin. Where a ray meets an edge, a vertex, a triangle seen edge-on, or
/// begins on a triangle, it is taken to be moved by an infinitesimal, always the same. Its const
/// functions may be called by several threads at once. They throw std::invalid_argument for
/// numbers that are not finite or from 1e300 on, and for a direction of length 0.
class PELLUCID_EXPORT MeshRays {
 public:
  /// Copies the mesh and builds a hierarchy of boxes, in n log n. Throws std::invalid_argument for
  /// a coordinate that is not finite, an index without a vertex, and no triangle.
  MeshRays(std::span<const Point3> vertices,
           std::span<const std::array<std::uint32_t, 3>> triangles);
  ~MeshRays();
  MeshRays(MeshRays&&) noexcept;
  MeshRays& operator=(MeshRays&&) noexcept;

  /// Returns all crossings in their order along the ray.
  std::vector<RayCrossing> all(const Point3& origin, const Point3& direction) const;
  /// Returns the nearest crossing, if there is one.
  std::optional<RayCrossing> first(const Point3& origin, const Point3& direction) const;
  /// Returns how many triangles the ray crosses; its parity tells inside from outside.
  std::size_t count(const Point3& origin, const Point3& direction) const;
  /// Returns whether the point is inside the mesh, which has to be closed.
  bool inside(const Point3& point) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace pellucid
