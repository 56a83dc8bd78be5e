// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Regular surfaces of triangles, for tests.

#include "geometry/triangle_mesh.h"

namespace pellucid::testing {

/// n × n squares of two triangles over [0, 1]², cut along the diagonals of x = y; each vertex lies
/// where `at` says, x fastest.
template <class At>
geometry::TriangleMesh woven_mesh(std::uint32_t n, const At& at) {
  geometry::TriangleMesh mesh;
  for (std::uint32_t j = 0; j <= n; ++j)
    for (std::uint32_t i = 0; i <= n; ++i)
      mesh.positions.push_back(at(double(i) / n, double(j) / n));
  for (std::uint32_t j = 0; j < n; ++j)
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = j * (n + 1) + i, b = a + n + 1;
      mesh.triangles.push_back({a, a + 1, b + 1});
      mesh.triangles.push_back({a, b + 1, b});
    }
  return mesh;
}

}  // namespace pellucid::testing
