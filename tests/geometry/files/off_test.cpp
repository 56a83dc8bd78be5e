// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/geometry/files/format_files.h"

namespace pellucid::geometry {
namespace {

using ::testing::HasSubstr;
using UnitOff = FormatFiles;

TEST_F(UnitOff, OffHasPolygonsCommentsAndCounts) {
  const TriangleMesh mesh = read_mesh(
      file("a.off",
           "OFF # a comment\n\n4 2 0\n0 0 0\n1 0 0\n1 1 0 # another\n0 1 0.5\n4 0 1 2 3 # black\n"
           "3 0 1 3\n"));
  EXPECT_EQ(mesh.positions.size(), 4u);
  EXPECT_EQ(mesh.positions[3], Vec3(0, 1, 0.5));
  EXPECT_EQ(mesh.triangles.size(), 3u);
  EXPECT_EQ(mesh.triangles[2], (std::array<std::uint32_t, 3>{0, 1, 3}));
  EXPECT_EQ(read_mesh(file("b.off", "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")).triangles.size(),
            1u);
}

TEST_F(UnitOff, OffHasNormalsAndColoursOfBytesOrShares) {
  const TriangleMesh bytes = read_mesh(
      file("a.off",
           "CNOFF\n3 1 0\n0 0 0 0 0 2 255 0 51 255\n1 0 0 0 0 2 0 0 0 0\n0 1 0 0 1 0 1 2 3\n"
           "3 0 1 2\n"));
  EXPECT_EQ(bytes.normals[0], Vec3(0, 0, 1));
  EXPECT_EQ(bytes.colors[0], Rgba(1, 0, 0.2f, 1));
  EXPECT_EQ(bytes.colors[1], Rgba(0));
  EXPECT_EQ(bytes.colors[2], Rgba(1 / 255.f, 2 / 255.f, 3 / 255.f, 1));
  const TriangleMesh shares = read_mesh(
      file("b.off", "COFF\n3 1 0\n0 0 0 1 0 0.5 0.25\n1 0 0 1 1 1 1\n0 1 0 0 0 0 0.5\n3 0 1 2\n"));
  EXPECT_EQ(shares.colors[0], Rgba(1, 0, 0.5f, 0.25f));
  EXPECT_EQ(shares.colors[1], Rgba(1));
}

/// What other programs write, though the format calls it COFF.
TEST_F(UnitOff, OffHasColoursUnderThePlainHead) {
  const TriangleMesh shares =
      read_mesh(file("a.off", "OFF\n3 1 0\n0 0 0 1 0 0\n1 0 0 1 1 1 0.5\n0 1 0\n3 0 1 2\n"));
  EXPECT_EQ(shares.colors[0], Rgba(1, 0, 0, 1));
  EXPECT_EQ(shares.colors[1], Rgba(1, 1, 1, 0.5f));
  EXPECT_EQ(shares.colors[2], Rgba(0.8f, 0.8f, 0.8f, 1));
  EXPECT_THAT(refusal([&] { read_mesh(file("a.off", "OFF\n3 1 0\n0 0 0 1\n")); }),
              HasSubstr(":3: a vertex of 4 numbers"));
}

/// 1 is a 255th in a file of bytes, whatever the other numbers of its vertex.
TEST_F(UnitOff, OffIsOfBytesAsAWhole) {
  const TriangleMesh mesh =
      read_mesh(file("a.off", "COFF\n3 1 0\n0 0 0 1 1 1\n1 0 0 255 1 0\n0 1 0 0 0 0\n3 0 1 2\n"));
  EXPECT_EQ(mesh.colors[0], Rgba(1 / 255.f, 1 / 255.f, 1 / 255.f, 1));
  EXPECT_EQ(mesh.colors[1], Rgba(1, 1 / 255.f, 0, 1));
  EXPECT_THAT(refusal([&] {
                read_mesh(file("a.off",
                               "COFF\n3 1 0\n0 0 0 255 0 0 0.5\n1 0 0 0 0 0\n0 1 0 0 0 0\n"
                               "3 0 1 2\n"));
              }),
              HasSubstr("red"));
}

TEST_F(UnitOff, OffHasColoursOfFaces) {
  const std::string points = "4 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
  const TriangleMesh mesh =
      read_mesh(file("a.off", "OFF\n" + points + "3 0 1 2 255 0 0\n3 0 2 3 0 0 51 0\n3 0 1 3 7\n"));
  const auto color = [&](std::size_t triangle, std::size_t corner) {
    return mesh.colors[mesh.triangles[triangle][corner]];
  };
  for (std::size_t corner = 0; corner < 3; ++corner) {
    EXPECT_EQ(color(0, corner), Rgba(1, 0, 0, 1));
    EXPECT_EQ(color(1, corner), Rgba(0, 0, 0.2f, 0));
    EXPECT_EQ(color(2, corner), Rgba(0.8f, 0.8f, 0.8f, 1));  // a number of a map tells no colour
  }
  EXPECT_EQ(mesh.positions.size(), 9u);
}

TEST_F(UnitOff, OffRefusesWhatItIsNot) {
  for (const auto& [content, said] :
       {std::pair("4OFF\n3 1 0\n", "'4OFF'; accepted"), std::pair("OFF BINARY\n", "BINARY"),
        std::pair("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", ":6: a face's vertex 3"),
        std::pair("OFF\n3 1 0\n0 0 0\n1 0\n", ":4: a vertex of 2 numbers"),
        std::pair("OFF\n1e15 1 0\n0 0 0\n", "number of vertices"),
        std::pair("OFF\n3 1 0\n0 0 x\n", "'x': expected a number"),
        std::pair("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4 0 1 2\n", "number of corners")})
    EXPECT_THAT(refusal([&] { read_mesh(file("a.off", content)); }), HasSubstr(said));
}

}  // namespace
}  // namespace pellucid::geometry
