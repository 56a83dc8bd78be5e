// SPDX-License-Identifier: GPL-3.0-or-later
// What a closed mesh bounds, against the closed form of a box.

#include "geometry/solid_mesh.h"

#include <gtest/gtest.h>

#include <random>

#include "core/error.h"

namespace pellucid::geometry {
namespace {

/// [-1, 1]³.
TriangleMesh cube() {
  TriangleMesh mesh;
  for (int corner = 0; corner < 8; ++corner)
    mesh.positions.emplace_back(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

double distance_to_cube(const Vec3& x) {
  const Vec3 beyond = glm::abs(x) - 1.0;
  return glm::length(glm::max(beyond, Vec3(0))) +
         std::min(std::max({beyond.x, beyond.y, beyond.z}), 0.0);
}

TEST(UnitSolidMesh, IsTheSignedDistanceBelowABound) {
  const SolidMesh solid(cube());
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1.6, 1.6);
  int within = 0;
  for (int i = 0; i < 4000; ++i) {
    // Half of the points on a lattice whose rays meet edges, corners and diagonals.
    Vec3 x(uniform(random), uniform(random), uniform(random));
    if (i % 2) x = glm::round(4.0 * x) / 4.0;
    for (const double bound : {0.0, 0.1, 0.4}) {
      const double distance = distance_to_cube(x);
      if (std::abs(distance - bound) < 1e-12) continue;
      EXPECT_EQ(solid.within(x, bound), distance < bound) << x.x << ' ' << x.y << ' ' << x.z;
      within += distance < bound;
    }
  }
  EXPECT_GT(within, 1000);
}

TEST(UnitSolidMesh, OpenMeshesAreRefused) {
  TriangleMesh open = cube();
  open.triangles.pop_back();
  EXPECT_THROW(SolidMesh{open}, InputError);
  EXPECT_THROW(SolidMesh{TriangleMesh{}}, InputError);
  TriangleMesh doubled = cube();  // an edge of four triangles
  doubled.triangles.insert(doubled.triangles.end(), {{0, 2, 1}, {0, 1, 2}});
  EXPECT_THROW(SolidMesh{doubled}, InputError);
}

}  // namespace
}  // namespace pellucid::geometry
