// SPDX-License-Identifier: GPL-3.0-or-later
// Edits of a half-edge mesh against one that is built anew.

#include "geometry/surface_mesh.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/geometry/half_edge_checks.h"

namespace pellucid::geometry {
namespace {

using namespace testing;

/// The mesh is what its own triangles are joined to.
void expect_as_built_anew(const SurfaceMesh& mesh) {
  expect_sound(mesh);
  const HalfEdges anew = half_edges(triangle_mesh(mesh));
  ASSERT_TRUE(anew.is_manifold());
  for (const FaceHandle face : mesh.faces())
    for (std::size_t k = 0; k < 3; ++k) {
      const auto beyond = [&](const SurfaceMesh& each) {
        return each.face_handle(each.opposite_halfedge_handle(sides(each, face)[k])).idx();
      };
      ASSERT_EQ(beyond(mesh), beyond(anew.mesh));
    }
}

TEST(PropertySurfaceMesh, TurningAndSplittingKeepAManifold) {
  SurfaceMesh mesh = join(49, grid(6, 6, false, false)).mesh;
  std::mt19937 random(1);
  for (int i = 0; i < 300; ++i) {
    const FaceHandle face(int(random() % mesh.n_faces()));
    const HalfedgeHandle side = sides(mesh, face)[random() % 3];
    if (i % 3 == 0)
      split_edge(mesh, side, mesh.add_vertex({double(i), 0, 1}));
    else if (mesh.is_flip_ok(mesh.edge_handle(side)))
      mesh.flip(mesh.edge_handle(side));
    expect_as_built_anew(mesh);
    if (HasFailure()) return;
  }
  EXPECT_EQ(euler_characteristic(mesh), 1);
  EXPECT_EQ(border_loops(mesh), 1u);
}

TEST(UnitSurfaceMesh, SplittingAnEdgeCutsItsFaces) {
  SurfaceMesh mesh = join(4, {{0, 1, 2}, {1, 0, 3}}).mesh;
  const auto around =
      split_edge(mesh, sides(mesh, FaceHandle(0))[0], mesh.add_vertex({0.5, 0.5, 0}));
  EXPECT_EQ(around, (std::array{FaceHandle(0), FaceHandle(2), FaceHandle(1), FaceHandle(3)}));
  EXPECT_EQ(triangle_mesh(mesh).triangles, (Triangles{{0, 4, 2}, {1, 4, 3}, {4, 1, 2}, {4, 0, 3}}));
  const auto at_border =
      split_edge(mesh, sides(mesh, FaceHandle(2))[1], mesh.add_vertex({1, 1, 1}));
  EXPECT_EQ(at_border, (std::array{FaceHandle(2), FaceHandle(4), FaceHandle(), FaceHandle()}));
  EXPECT_EQ(corners(mesh, FaceHandle(2)), (Corners{1, 5, 4}));
  EXPECT_EQ(corners(mesh, FaceHandle(4)), (Corners{5, 2, 4}));
  expect_sound(mesh);
}

}  // namespace
}  // namespace pellucid::geometry
