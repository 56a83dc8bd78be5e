// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/triangle_mesh.h"

namespace pellucid::integrators {

/// Percentiles are the 1st, the 50th and the 99th of a set of numbers, and the largest.
struct Percentiles {
  double p1 = 0, p50 = 0, p99 = 0, max = 0;
};

/// How sound a triangle mesh is, whatever it shows.
struct MeshQuality {
  std::uint64_t boundary_edges = 0;
  std::uint64_t non_manifold_edges = 0;     // with more than two triangles
  std::uint64_t misoriented_edges = 0;      // whose two triangles run along it the same way
  std::uint64_t non_manifold_vertices = 0;  // where several fans of triangles meet
  std::uint64_t duplicate_vertices = 0;     // at exactly the place of another one
  std::uint64_t unused_vertices = 0;
  std::uint64_t degenerate_triangles = 0;  // of no area, to rounding
  std::uint64_t sheets = 0;                // connected by edges
  std::uint64_t sheets_by_vertices = 0;    // connected by edges or by a vertex alone
  bool manifold = false;                   // as a half-edge mesh: no edge or vertex is singular
  Percentiles min_angle;                   // degrees, of each triangle's smallest angle
  Percentiles aspect;          // longest side over the height on it, × √3/2: 1 is best
  Percentiles normal_degrees;  // facet normal against its vertices' normals; 0 without normals
};

/// Measures connectivity and shapes, in time linear in the mesh but for sorting.
MeshQuality measure_quality(const geometry::TriangleMesh& mesh);

}  // namespace pellucid::integrators
