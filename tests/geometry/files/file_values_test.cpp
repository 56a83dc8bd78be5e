// SPDX-License-Identifier: GPL-3.0-or-later
// Scalars as a file has them, where vertices repeat them: at the corners of a face or along a line.

#include "tests/geometry/files/format_files.h"

namespace pellucid::geometry {
namespace {

using ::testing::ElementsAre;
using UnitFileValues = FormatFiles;

std::string faces_ply(const std::string& properties, const std::string& faces) {
  return "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
         "property float z\nproperty float v\nelement face 3\n"
         "property list uchar int vertex_indices\n" +
         properties + "end_header\n0 0 0 1\n1 0 0 2\n1 1 0 3\n0 1 0 4\n" + faces;
}

TEST_F(UnitFileValues, AFaceCountsOnceWhateverItsCorners) {
  const FileMesh mesh = read_mesh(
      file("a.ply", faces_ply("property float s\n", "3 0 1 2 7\n4 0 1 2 3 8\n3 0 2 3 9\n")));
  EXPECT_EQ(mesh.triangles.size(), 4u);
  EXPECT_THAT(mesh.values.at("s"), ElementsAre(7, 8, 9));
  EXPECT_FALSE(mesh.values.contains("v"));  // which no vertex repeats
}

TEST_F(UnitFileValues, AVertexCountsOnceThoughColoursOfFacesSplitIt) {
  const FileMesh mesh = read_mesh(
      file("a.ply", faces_ply("property uchar red\nproperty uchar green\nproperty uchar blue\n",
                              "3 0 1 2 255 0 0\n3 0 2 3 0 255 0\n3 0 1 3 0 0 255\n")));
  EXPECT_EQ(mesh.positions.size(), 9u);
  EXPECT_THAT(mesh.values.at("v"), ElementsAre(1, 2, 3, 4));
  EXPECT_EQ(mesh.values.size(), 1u);  // colours are no scalars
}

TEST_F(UnitFileValues, CellsAndPointsOfVtkCountOnce) {
  const fs::path path =
      file("a.vtk",
           "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n"
           "0 0 0 1 0 0 1 1 0 0 1 0\nLINES 2 7\n3 0 1 2\n2 2 3\nPOLYGONS 2 9\n4 0 1 2 3\n3 0 1 2\n"
           "CELL_DATA 4\nSCALARS c float 1\nLOOKUP_TABLE default\n1 2 3 4\n"
           "POINT_DATA 4\nSCALARS p float 1\nLOOKUP_TABLE default\n5 6 7 8\n");
  const FileMesh mesh = read_mesh(path);
  EXPECT_THAT(mesh.values.at("c"), ElementsAre(3, 4));
  EXPECT_FALSE(mesh.values.contains("p"));
  const FileLines lines = read_lines(path);
  EXPECT_THAT(lines.scalars.at("p"), ElementsAre(5, 6, 7, 7, 8));
  EXPECT_THAT(lines.values.at("c"), ElementsAre(1, 2));
  EXPECT_THAT(lines.values.at("p"), ElementsAre(5, 6, 7, 8));
}

TEST_F(UnitFileValues, EdgesAndTheirEndsCountOnce) {
  const FileLines lines = read_lines(
      file("a.ply",
           "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
           "property float z\nproperty float v\nelement edge 3\nproperty int vertex1\n"
           "property int vertex2\nproperty float e\nend_header\n0 0 0 1\n1 0 0 2\n2 0 0 3\n"
           "0 1 10\n1 2 20\n2 0 30\n"));
  EXPECT_EQ(lines.positions.size(), 6u);
  EXPECT_THAT(lines.values.at("v"), ElementsAre(1, 2, 3));
  EXPECT_THAT(lines.values.at("e"), ElementsAre(10, 20, 30));
  EXPECT_EQ(lines.values.size(), 2u);
}

}  // namespace
}  // namespace pellucid::geometry
