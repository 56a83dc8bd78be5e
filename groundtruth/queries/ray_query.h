// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/triangle_mesh.h"
#include "groundtruth/queries/free_ray.h"

namespace pellucid::groundtruth {

/// A RayHit is where a ray crosses a mesh.
struct RayHit : TriangleHit {
  std::uint32_t triangle;  // of the mesh

  /// Orders hits along the ray, those of equal t by triangle. A RayQuery gives hits whose exact t
  /// are equal the same t, to the last bit.
  friend bool operator<(const RayHit& p, const RayHit& q) {
    return p.t != q.t ? p.t < q.t : p.triangle < q.triangle;
  }
};

/// A RayQuery answers for rays of any origin and direction which triangles of a mesh they cross,
/// each decided by cross(). It walks a hierarchy of boxes in double; it is thread-safe once it is
/// made.
class RayQuery {
 public:
  /// Builds the hierarchy. Throws InputError for a mesh that read_mesh() would refuse.
  explicit RayQuery(geometry::TriangleMesh mesh);

  /// Returns all crossings in front of the origin, in their order along the ray. Throws InputError,
  /// as all do, for a ray of which a number is not finite, or from 1e300 on, and for a direction of
  /// length 0.
  std::vector<RayHit> all(const FreeRay& ray) const;
  /// Returns the nearest crossing, if there is one.
  std::optional<RayHit> first(const FreeRay& ray) const;
  /// Returns how many triangles the ray crosses.
  std::size_t count(const FreeRay& ray) const;
  /// Returns whether the point lies inside a closed mesh: whether a ray from it crosses the mesh an
  /// odd number of times. A point on the surface is taken to lie beside it, see cross(). Of a mesh
  /// that is not closed it says nothing.
  bool inside(const Vec3& point) const;

  const geometry::TriangleMesh& mesh() const { return mesh_; }

 private:
  /// A Node's children follow it: the left one at once, the right one at `right`. A leaf holds
  /// `count` triangles of order_ from `right` on.
  struct Node {
    Box3 box;
    std::uint32_t right, count;
  };

  std::uint32_t build(std::uint32_t begin, std::uint32_t end, const std::vector<Vec3>& centers);
  template <class Visit>
  void visit(const FreeRay& ray, const double& farthest, const Visit& hit) const;
  void settle(const FreeRay& ray, RayHit& p, RayHit& q) const;

  geometry::TriangleMesh mesh_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace pellucid::groundtruth
