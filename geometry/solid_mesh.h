// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "geometry/triangle_mesh.h"

namespace pellucid::geometry {

/// A SolidMesh is the solid that a closed mesh bounds, in world units. It is immutable; any number
/// of threads may ask.
class SolidMesh {
 public:
  /// Copies the triangles. Throws InputError for a mesh without triangles or with an edge of other
  /// than two.
  explicit SolidMesh(const TriangleMesh& mesh);
  ~SolidMesh();

  /// Says whether x lies inside, or outside and nearer to the surface than `distance` (at least 0,
  /// world units): whether its signed distance, negative inside, is below `distance`.
  bool within(const Vec3& x, double distance) const;

 private:
  struct State;
  std::unique_ptr<const State> state_;
};

}  // namespace pellucid::geometry
