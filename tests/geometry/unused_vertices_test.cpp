// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/unused_vertices.h"

#include <gmock/gmock.h>

namespace pellucid::geometry {
namespace {

using ::testing::ElementsAre;

TEST(UnitUnusedVertices, OfAMeshGoWithAllThatTheyCarry) {
  TriangleMesh mesh;
  for (int i = 0; i < 5; ++i) {
    mesh.positions.emplace_back(i, 0, 0);
    mesh.normals.emplace_back(0, 0, i);
    mesh.colors.emplace_back(float(i));
    mesh.importance.push_back(float(i));
    mesh.scalars["s"].push_back(i);
  }
  mesh.triangles = {{4, 1, 3}, {3, 1, 4}};
  drop_unused_vertices(mesh);
  EXPECT_THAT(mesh.positions, ElementsAre(Vec3(1, 0, 0), Vec3(3, 0, 0), Vec3(4, 0, 0)));
  EXPECT_THAT(mesh.normals, ElementsAre(Vec3(0, 0, 1), Vec3(0, 0, 3), Vec3(0, 0, 4)));
  EXPECT_THAT(mesh.colors, ElementsAre(Rgba(1), Rgba(3), Rgba(4)));
  EXPECT_THAT(mesh.importance, ElementsAre(1, 3, 4));
  EXPECT_THAT(mesh.scalars["s"], ElementsAre(1, 3, 4));
  EXPECT_THAT(mesh.triangles, ElementsAre(std::array<std::uint32_t, 3>{2, 0, 1},
                                          std::array<std::uint32_t, 3>{1, 0, 2}));
  EXPECT_THAT(mesh.remarks, ElementsAre("2 of 5 vertices are of no triangle, and are left out"));
  drop_unused_vertices(mesh);  // there are none any more
  EXPECT_EQ(mesh.positions.size(), 3u);
  EXPECT_EQ(mesh.remarks.size(), 1u);
}

TEST(UnitUnusedVertices, OfLinesAreThoseThatNoSegmentJoins) {
  LineSet lines;
  for (int i = 0; i < 7; ++i) lines.positions.emplace_back(i, 0, 0);
  lines.offsets = {1, 3, 4, 4, 6};  // none of 0, 1 and 2, 3 alone, none, 4 and 5; 6 is of no line
  drop_unused_vertices(lines);
  EXPECT_THAT(lines.positions,
              ElementsAre(Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(4, 0, 0), Vec3(5, 0, 0)));
  EXPECT_THAT(lines.offsets, ElementsAre(0, 2, 2, 2, 4));
  EXPECT_THAT(lines.remarks, ElementsAre("3 of 7 vertices are of no segment, and are left out"));
}

}  // namespace
}  // namespace pellucid::geometry
