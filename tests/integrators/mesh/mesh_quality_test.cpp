// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/mesh/mesh_quality.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pellucid::integrators {
namespace {

geometry::TriangleMesh two_triangles() {
  geometry::TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0.5, std::sqrt(0.75), 0}, {1.5, std::sqrt(0.75), 0}};
  mesh.triangles = {{0, 1, 2}, {1, 3, 2}};
  return mesh;
}

TEST(UnitMeshQuality, EquilateralTrianglesAreTheBest) {
  const MeshQuality quality = measure_quality(two_triangles());
  // Some five roundings of 1.1e-16 in radians, times 57; the aspect likewise.
  EXPECT_NEAR(quality.min_angle.p50, 60, 5e-14);
  EXPECT_NEAR(quality.aspect.max, 1, 1e-15);
  EXPECT_EQ(quality.boundary_edges, 4u);
  EXPECT_EQ(quality.sheets, 1u);
  EXPECT_TRUE(quality.manifold);
}

TEST(UnitMeshQuality, FindsEveryFault) {
  geometry::TriangleMesh mesh = two_triangles();
  mesh.triangles.push_back({1, 2, 0});  // a third one on the edges of the first
  EXPECT_EQ(measure_quality(mesh).non_manifold_edges, 1u);
  EXPECT_EQ(measure_quality(mesh).sheets, 1u);  // by their edges, joined there or not
  EXPECT_FALSE(measure_quality(mesh).manifold);

  mesh = two_triangles();
  mesh.triangles[1] = {2, 3, 1};  // turned over
  EXPECT_EQ(measure_quality(mesh).misoriented_edges, 1u);
  EXPECT_FALSE(measure_quality(mesh).manifold);

  mesh = two_triangles();
  mesh.positions.push_back(mesh.positions[0]);
  EXPECT_EQ(measure_quality(mesh).duplicate_vertices, 1u);
  EXPECT_EQ(measure_quality(mesh).unused_vertices, 1u);

  mesh = two_triangles();
  mesh.positions[3] = 0.5 * (mesh.positions[1] + mesh.positions[2]);
  EXPECT_EQ(measure_quality(mesh).degenerate_triangles, 1u);
}

TEST(UnitMeshQuality, TwoTrianglesInOneVertexAreTwoSheetsAndNoManifold) {
  geometry::TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 3, 4}};
  EXPECT_EQ(measure_quality(mesh).sheets, 2u);
  EXPECT_EQ(measure_quality(mesh).sheets_by_vertices, 1u);
  EXPECT_EQ(measure_quality(mesh).non_manifold_vertices, 1u);
  EXPECT_EQ(measure_quality(mesh).boundary_edges, 6u);
  EXPECT_FALSE(measure_quality(mesh).manifold);
}

TEST(UnitMeshQuality, NormalsAreComparedWithFacets) {
  geometry::TriangleMesh mesh = two_triangles();
  mesh.normals.assign(4, Vec3(0, std::sin(0.1), std::cos(0.1)));
  // The constant is rounded at its tenth digit: 0.1 · 5e-9 degrees.
  EXPECT_NEAR(measure_quality(mesh).normal_degrees.p50, 0.1 * 57.29577951, 1e-9);
}

}  // namespace
}  // namespace pellucid::integrators
