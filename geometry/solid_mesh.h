// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "geometry/triangle_mesh.h"

namespace pellucid::geometry {

/// What a closed mesh bounds. Immutable; any number of threads may ask.
class SolidMesh {
 public:
  /// Throws InputError for a mesh with an edge of other than two triangles.
  explicit SolidMesh(const TriangleMesh& mesh);
  ~SolidMesh();

  /// Whether x lies inside, or outside and nearer to the surface than `distance` (at least 0):
  /// whether its signed distance, negative inside, is below `distance`.
  bool within(const Vec3& x, double distance) const;

 private:
  struct State;
  std::unique_ptr<const State> state_;
};

}  // namespace pellucid::geometry
