// SPDX-License-Identifier: GPL-3.0-or-later
// Strips, Gaussian splats, and what lines carry in the formats that can.

#include <cmath>

#include "tests/geometry/files/format_files.h"

namespace pellucid::geometry {
namespace {

using ::testing::HasSubstr;
using UnitPlyExtensions = FormatFiles;

TEST_F(UnitPlyExtensions, PlyStripsAreTrianglesThatFaceOneWay) {
  const TriangleMesh mesh =
      read_mesh(file("a.ply",
                     "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
                     "property float z\nelement tristrips 1\nproperty list int int vertex_indices\n"
                     "end_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n9 0 1 2 3 4 -1 1 3 2\n"));
  ASSERT_EQ(mesh.triangles.size(), 4u);
  for (const auto& [a, b, c] : mesh.triangles)
    EXPECT_GT(
        glm::cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]).z,
        0);
  EXPECT_THAT(
      refusal([&] {
        read_mesh(file("b.ply",
                       "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty "
                       "float y\nproperty float z\nelement tristrips 1\nproperty list int "
                       "int vertex_indices\nend_header\n0 0 0\n3 0 -2 0\n"));
      }),
      HasSubstr("vertex index -2"));
}

TEST_F(UnitPlyExtensions, PlyOfGaussiansHasTheirColoursOpacitiesAndSizes) {
  const PointSet points = read_points(
      file("a.ply",
           "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
           "property float z\nproperty float f_dc_0\nproperty float f_dc_1\nproperty float f_dc_2\n"
           "property float f_rest_0\nproperty float opacity\nproperty float scale_0\n"
           "property float scale_1\nproperty float scale_2\nend_header\n"
           "1 2 3 0 1 -100 9 0 0 0 0\n4 5 6 0 0 0 9 1.0986122886681098 -3 -1 1\n"));
  // 1 / (2 √π) = 0.28209479; a float's rounding.
  EXPECT_NEAR(points.colors[0].g, 0.5 + 0.28209479, 1e-7);
  EXPECT_EQ(points.colors[0].r, 0.5f);
  EXPECT_EQ(points.colors[0].b, 0);
  EXPECT_EQ(points.colors[0].a, 0.5f);
  EXPECT_NEAR(points.colors[1].a, 0.75, 1e-7);  // the logit is ln 3
  EXPECT_EQ(points.scalars.at("radius")[0], 1);
  EXPECT_NEAR(points.scalars.at("radius")[1], std::exp(-1), 1e-15);
  EXPECT_FALSE(points.scalars.contains("f_rest_0"));
}

TEST_F(UnitPlyExtensions, LinesKeepWhatTheyCarryWhereTheFormatCan) {
  LineSet lines;
  lines.positions = {{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {5, 5, 5}, {6, 6, 7}};
  lines.offsets = {0, 3, 5};
  lines.colors = {Rgba(1, 0, 0, 0.5f), Rgba(0, 1, 0, 1), Rgba(0), Rgba(1), Rgba(0, 0, 1, 0.25f)};
  lines.importance = {0, 0.5f, 1, 0.25f, 0};
  lines.scalars["speed"] = {1, 2, 3, 4, 1e-300};
  for (const char* name : {"a.ply", "a.vtp", "a.vtu"}) {
    write_lines(folder_ / name, lines);
    const LineSet back = read_lines(folder_ / name);
    EXPECT_EQ(back.positions, lines.positions) << name;
    EXPECT_EQ(back.offsets, lines.offsets) << name;
    EXPECT_EQ(back.colors, lines.colors) << name;
    EXPECT_EQ(back.importance, lines.importance) << name;
    EXPECT_EQ(back.scalars, lines.scalars) << name;
  }
  EXPECT_THAT(read_text(folder_ / "a.ply"), HasSubstr("element edge 3\n"));
}

}  // namespace
}  // namespace pellucid::geometry
