// SPDX-License-Identifier: GPL-3.0-or-later
// What is called alpha or importance is one where the file means it so; colours of faces and alphas
// of vertices count together.

#include "tests/geometry/files/format_files.h"

namespace pellucid::geometry {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class UnitChannels : public FormatFiles {
 protected:
  /// A triangle of legacy VTK with arrays of its points and of its cell.
  fs::path triangle(const std::string& of_points, const std::string& of_cell = "") const {
    return file("a.vtk",
                "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n"
                "0 0 0 1 0 0 0 1 0\nPOLYGONS 1 4\n3 0 1 2\n" +
                    (of_points.empty() ? "" : "POINT_DATA 3\n" + of_points) +
                    (of_cell.empty() ? "" : "CELL_DATA 1\n" + of_cell));
  }
  static std::string scalars(const std::string& name, const std::string& values,
                             const std::string& type = "float") {
    return "SCALARS " + name + " " + type + " 1\nLOOKUP_TABLE default\n" + values + "\n";
  }
};

TEST_F(UnitChannels, AnAlphaOfVtkWithoutAColourIsAScalar) {
  const TriangleMesh mesh = read_mesh(triangle(scalars("alpha", "0.25 0.5 1.5")));
  EXPECT_THAT(mesh.scalars.at("alpha"), ElementsAre(0.25, 0.5, 1.5));
  EXPECT_THAT(mesh.colors, IsEmpty());
  EXPECT_THAT(mesh.remarks, ElementsAre("'alpha' has no red, green and blue beside it and is no "
                                        "opacity: it is a scalar"));
  const PointSet points = read_points(folder_ / "a.vtk");
  EXPECT_THAT(points.scalars.at("alpha"), ElementsAre(0.25, 0.5, 1.5));
  EXPECT_THAT(points.remarks, ElementsAre(HasSubstr("it is a scalar")));
  // Bytes are what they are, and so is a red alone.
  EXPECT_THAT(
      read_mesh(triangle(scalars("alpha", "0 51 255", "unsigned_char"))).scalars.at("alpha"),
      ElementsAre(0, 51, 255));
  EXPECT_THAT(read_mesh(triangle(scalars("red", "0 51 255", "unsigned_char"))).scalars.at("red"),
              ElementsAre(0, 51, 255));
}

TEST_F(UnitChannels, AnAlphaOfVtkBesideAColourIsItsOpacity) {
  std::string channels;
  for (const char* name : {"red", "green", "blue", "alpha"})
    channels += scalars(name, "51 51 51", "unsigned_char");
  const TriangleMesh mesh = read_mesh(triangle(channels));
  EXPECT_EQ(mesh.colors, std::vector<Rgba>(3, Rgba(0.2f)));
  EXPECT_THAT(mesh.remarks, IsEmpty());
}

/// COLOR_SCALARS of one number are a luminance, which VTK draws as it stands.
TEST_F(UnitChannels, GreysOfVtkAreNamed) {
  for (const auto& [points, cell] :
       {std::pair("COLOR_SCALARS c 1\n0.2 0.4 0.6\n", ""), {"", "COLOR_SCALARS c 2\n0.2 1\n"}}) {
    const TriangleMesh mesh = read_mesh(triangle(points, cell));
    EXPECT_THAT(mesh.colors, IsEmpty());
    EXPECT_THAT(mesh.remarks, ElementsAre("'c' is of bytes, which VTK draws as greys: here it is "
                                          "read as scalars"));
  }
  EXPECT_THAT(read_mesh(triangle("COLOR_SCALARS c 3\n1 0 0 1 0 0 1 0 0\n")).remarks, IsEmpty());
  EXPECT_THAT(read_mesh(triangle(scalars("s", "1 2 3"))).remarks, IsEmpty());
}

TEST_F(UnitChannels, AnImportanceOfVtkBeyondTheUnitIsAScalar) {
  const TriangleMesh within = read_mesh(triangle(scalars("importance", "0 0.5 1")));
  EXPECT_THAT(within.importance, ElementsAre(0, 0.5, 1));
  const TriangleMesh beyond = read_mesh(triangle(scalars("importance", "0 0.5 2")));
  EXPECT_THAT(beyond.importance, IsEmpty());
  EXPECT_THAT(beyond.scalars.at("importance"), ElementsAre(0, 0.5, 2));
  EXPECT_THAT(beyond.remarks,
              ElementsAre("'importance' goes beyond 0 … 1 and is no importance: it is a scalar"));
}

TEST_F(UnitChannels, ColoursOfVtksCellsGoWithTheAlphaOfItsPoints) {
  const TriangleMesh mesh =
      read_mesh(triangle(scalars("alpha", "0.25 0.5 1"), "COLOR_SCALARS c 3\n0.25 0.5 0.75\n"));
  for (const std::uint32_t corner : mesh.triangles[0]) {
    const double x = mesh.positions[corner].x, y = mesh.positions[corner].y;
    // VTK reads COLOR_SCALARS as bytes.
    EXPECT_NEAR(mesh.colors[corner].r, 0.25, 1.0 / 255);
    EXPECT_EQ(mesh.colors[corner].a, x == 1 ? 0.5f : y == 1 ? 1.0f : 0.25f);
  }
  EXPECT_THAT(mesh.remarks, IsEmpty());
  // Faces with an opacity of their own keep it.
  const TriangleMesh both =
      read_mesh(triangle(scalars("alpha", "0.25 0.5 1"), "COLOR_SCALARS c 4\n0.25 0.5 0.75 0.5\n"));
  for (const Rgba& color : both.colors) EXPECT_NEAR(color.a, 0.5, 1.0 / 255);
  EXPECT_THAT(both.remarks,
              ElementsAre("the alpha of its vertices is left out: its faces have one, too"));
}

TEST_F(UnitChannels, ColoursOfVtksLinesGoWithTheAlphaOfTheirPoints) {
  const auto read = [&](const std::string& color) {
    return read_lines(file("a.vtk",
                           "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\n"
                           "POINTS 2 float\n0 0 0 1 0 0\nLINES 1 3\n2 0 1\nPOINT_DATA 2\n" +
                               scalars("alpha", "0.25 0.75") + "CELL_DATA 1\n" + color));
  };
  const LineSet lines = read("COLOR_SCALARS c 3\n0 1 0\n");
  EXPECT_THAT(lines.colors, ElementsAre(Rgba(0, 1, 0, 0.25f), Rgba(0, 1, 0, 0.75f)));
  EXPECT_THAT(lines.remarks, IsEmpty());
  const LineSet both = read("COLOR_SCALARS c 4\n0 1 0 1\n");
  EXPECT_THAT(both.colors, ElementsAre(Rgba(0, 1, 0, 1), Rgba(0, 1, 0, 1)));
  EXPECT_THAT(both.remarks,
              ElementsAre("the alpha of its points is left out: its cells have one, too"));
}

TEST_F(UnitChannels, ColoursOfPlysFacesGoWithTheAlphaOfItsVertices) {
  const auto read = [&](const std::string& more, const std::string& color) {
    return read_mesh(
        file("a.ply",
             "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
             "property float z\nproperty uchar alpha\nelement face 1\n"
             "property list uchar int vertex_indices\nproperty uchar red\n"
             "property uchar green\nproperty uchar blue\n" +
                 more + "end_header\n0 0 0 51\n1 0 0 102\n0 1 0 204\n3 0 1 2 51 102 204" + color +
                 "\n"));
  };
  const TriangleMesh mesh = read("", "");
  EXPECT_THAT(mesh.colors, ElementsAre(Rgba(0.2f, 0.4f, 0.8f, 0.2f), Rgba(0.2f, 0.4f, 0.8f, 0.4f),
                                       Rgba(0.2f, 0.4f, 0.8f, 0.8f)));
  EXPECT_THAT(mesh.remarks, IsEmpty());
  const TriangleMesh both = read("property uchar alpha\n", " 255");
  EXPECT_EQ(both.colors, std::vector<Rgba>(3, Rgba(0.2f, 0.4f, 0.8f, 1)));
  EXPECT_THAT(both.remarks, ElementsAre(HasSubstr("alpha of its vertices is left out")));
}

TEST_F(UnitChannels, NumbersOfPlysVerticesComeBeforeThoseOfItsEdges) {
  const LineSet lines = read_lines(
      file("a.ply",
           "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
           "property float z\nproperty float q\nproperty uchar red\nproperty uchar green\n"
           "property uchar blue\nelement edge 2\nproperty int vertex1\n"
           "property int vertex2\nproperty float q\nproperty float e\nproperty uchar red\n"
           "property uchar green\nproperty uchar blue\nend_header\n0 0 0 1 51 51 51\n"
           "1 0 0 2 51 51 51\n1 1 0 3 51 51 51\n0 1 10 7 0 0 0\n1 2 20 8 0 0 0\n"));
  EXPECT_THAT(lines.scalars.at("q"), ElementsAre(1, 2, 2, 3));
  EXPECT_THAT(lines.scalars.at("e"), ElementsAre(7, 7, 8, 8));
  EXPECT_EQ(lines.colors, std::vector<Rgba>(4, Rgba(0.2f, 0.2f, 0.2f, 1)));
}

}  // namespace
}  // namespace pellucid::geometry
