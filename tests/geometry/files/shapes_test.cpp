// SPDX-License-Identifier: GPL-3.0-or-later
// What shapes mean, whatever their file: polygons, normals, edges, hidden cells, colours.

#include <fmt/format.h>

#include <gmock/gmock.h>

#include <cmath>

#include "core/error.h"
#include "core/files/output_file.h"
#include "geometry/files/mesh_file.h"
#include "tests/support/mesh_area.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::geometry {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::TemporaryFolder;

class UnitShapes : public ::testing::Test {
 protected:
  fs::path file(const std::string& name, const std::string& text) const {
    write_text(folder_ / name, text);
    return folder_ / name;
  }
  TemporaryFolder folder_;
};

std::string ply(const std::string& properties, const std::string& rest) {
  return "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
         "float z\n" +
         properties + rest;
}
const std::string face = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";

/// Two squares side by side, as legacy polygons, with `data` behind.
std::string squares(const std::string& data) {
  return "# vtk DataFile Version 3.0\nc\nASCII\nDATASET POLYDATA\nPOINTS 6 float\n"
         "0 0 0 1 0 0 1 1 0 0 1 0 2 0 0 2 1 0\nPOLYGONS 2 10\n4 0 1 2 3\n4 1 4 5 2\n" +
         data;
}

/// Two cubes in a row along x, as legacy hexahedra.
std::string cubes(const std::string& data) {
  return "# vtk DataFile Version 3.0\nc\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 12 float\n"
         "0 0 0 1 0 0 2 0 0 0 1 0 1 1 0 2 1 0 0 0 1 1 0 1 2 0 1 0 1 1 1 1 1 2 1 1\n"
         "CELLS 2 18\n8 0 1 4 3 6 7 10 9\n8 1 2 5 4 7 8 11 10\nCELL_TYPES 2\n12 12\n" +
         data;
}

TEST_F(UnitShapes, AConcavePolygonCoversItsAreaInEveryFormat) {
  const std::string points = "3 0 0 3 1 0 1 1 0 1 3 0 0 3 0 0 0 0";
  const fs::path files[] = {
      file("l.obj", "v 3 0 0\nv 3 1 0\nv 1 1 0\nv 1 3 0\nv 0 3 0\nv 0 0 0\nf 1 2 3 4 5 6\n"),
      file("l.ply",
           "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty "
           "float z\n" +
               face + points + "\n6 0 1 2 3 4 5\n"),
      file("l.vtk", "# vtk DataFile Version 3.0\nL\nASCII\nDATASET POLYDATA\nPOINTS 6 float\n" +
                        points + "\nPOLYGONS 1 7\n6 0 1 2 3 4 5\n"),
      file("cells.vtk",
           "# vtk DataFile Version 3.0\nL\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 6 float\n" +
               points + "\nCELLS 1 7\n6 0 1 2 3 4 5\nCELL_TYPES 1\n7\n")};
  for (const fs::path& path : files) {
    const TriangleMesh mesh = read_mesh(path);
    EXPECT_EQ(mesh.triangles.size(), 4u) << path;
    EXPECT_NEAR(testing::area_of(mesh), 5, 1e-14) << path;
  }
}

TEST_F(UnitShapes, ScalarsOfCellsAreThoseOfTheirTriangles) {
  const TriangleMesh two = read_mesh(file(
      "two.vtk", squares("CELL_DATA 2\nSCALARS region double 1\nLOOKUP_TABLE default\n7 9\n")));
  ASSERT_EQ(two.triangles.size(), 4u);
  EXPECT_EQ(two.face_scalars.at("region"), (std::vector<double>{7, 7, 9, 9}));
  EXPECT_FALSE(two.scalars.contains("region"));
}

TEST_F(UnitShapes, TheBoundaryOfCellsKeepsTheirScalars) {
  const TriangleMesh mesh = read_mesh(
      file("cubes.vtk", cubes("CELL_DATA 2\nSCALARS part int 1\nLOOKUP_TABLE default\n3 4\n")));
  ASSERT_EQ(mesh.face_scalars.at("part").size(), mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    double x = 0;  // of the triangle's centre: the cubes meet at 1
    for (const std::uint32_t v : mesh.triangles[i]) x += mesh.positions[v].x / 3;
    EXPECT_EQ(mesh.face_scalars.at("part")[i], x < 1 ? 3 : 4);
  }
}

TEST_F(UnitShapes, AScalarOfALineIsAtAllOfItsPoints) {
  const LineSet lines = read_lines(file(
      "lines.vtk",
      "# vtk DataFile Version 3.0\nl\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n0 0 0 1 0 0 1 1 0\n"
      "LINES 2 6\n2 0 1\n2 1 2\nCELL_DATA 2\nSCALARS part int 1\nLOOKUP_TABLE default\n3 4\n"));
  EXPECT_EQ(lines.scalars.at("part"), (std::vector<double>{3, 3, 4, 4}));
}

TEST_F(UnitShapes, EveryObjFaceKeepsItsOwnNormals) {
  const TriangleMesh mesh =
      read_mesh(file("roof.obj",
                     "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0 0 -1\nvn 0 -2 0\nvn 0 0 -1\n"
                     "f 1//1 3//1 2//1\nf 1//2 2//2 4//2\nf 3//3 2//1 1//1\n"));
  // Normal 3 is normal 1 again, so that the third face has the first's vertices.
  EXPECT_EQ(mesh.positions.size(), 6u);
  const Vec3 normals[] = {{0, 0, -1}, {0, -1, 0}, {0, 0, -1}};
  for (int row = 0; row < 3; ++row)
    for (const std::uint32_t v : mesh.triangles[std::size_t(row)])
      EXPECT_EQ(mesh.normals[v], normals[row]) << row;
}

TEST_F(UnitShapes, ObjFacesWithoutNormalsGetThoseOfTheirFacets) {
  const TriangleMesh mesh = read_mesh(file("half.obj",
                                           "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0 0 1\n"
                                           "f 1//1 2//1 3//1\nf 1 2 4\n"));
  for (const std::uint32_t v : mesh.triangles[0]) EXPECT_EQ(mesh.normals[v], Vec3(0, 0, 1));
  for (const std::uint32_t v : mesh.triangles[1]) EXPECT_EQ(mesh.normals[v], Vec3(0, -1, 0));
}

TEST_F(UnitShapes, NormalsThatAreNoneComeFromTheFacets) {
  const std::string normals = "property float nx\nproperty float ny\nproperty float nz\n";
  const TriangleMesh some = read_mesh(
      file("some.ply", ply(normals, face + "0 0 0 1 0 0\n1 0 0 0 0 0\n0 1 0 nan 0 0\n3 0 1 2\n")));
  EXPECT_EQ(some.normals, (std::vector<Vec3>{{1, 0, 0}, {0, 0, 1}, {0, 0, 1}}));
  const TriangleMesh all = read_mesh(
      file("all.ply", ply(normals, face + "0 0 0 0 0 0\n1 0 0 0 0 0\n0 1 0 0 0 0\n3 0 1 2\n")));
  EXPECT_TRUE(all.normals.empty());
}

TEST_F(UnitShapes, ObjStatementsGoOnBehindABackslash) {
  const fs::path path = file("c.obj",
                             "v 0 0 0\r\nv 1 \\\r\n 0 0\r\nv 1 1 0\r\n# no end \\\r\n"
                             "v 0 1 0\r\nf 1 2 \\ \r\n3 4\r\nf 1 2 9\r\n");
  try {
    read_mesh(path);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("c.obj:9: vertex index 9, but 4"));
  }
  EXPECT_EQ(read_mesh(file("d.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 \\\n3 \\\n4\n"))
                .triangles.size(),
            2u);
}

TEST_F(UnitShapes, ObjLinesHaveTheirTextureNumbersAsAttributes) {
  const LineSet lines = read_lines(
      file("t.obj", "v 0 0 0\nvt 0.25 7\nv 1 0 0\nvt 0.5\nv 2 0 0\nvt 1\nl 3 2\nl 1/3 2\n"));
  EXPECT_EQ(lines.scalars.at("attribute0"), (std::vector<double>{1, 0.5, 1, 0.5}));
  EXPECT_TRUE(std::isnan(lines.scalars.at("attribute1")[0]));
}

TEST_F(UnitShapes, PlyEdgesAreLines) {
  const std::string edges = "element edge 3\nproperty int vertex1\nproperty int vertex2\n";
  const std::string points = "end_header\n0 0 0\n1 0 0\n0 1 0\n";
  const LineSet joined = read_lines(file("e.ply", ply("", edges + points + "0 1\n1 2\n0 2\n")));
  EXPECT_EQ(joined.offsets, (std::vector<std::uint64_t>{0, 3, 5}));
  EXPECT_EQ(joined.positions,
            (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {0, 1, 0}}));
  const LineSet coloured = read_lines(file(
      "c.ply", ply("", edges + "property uchar red\nproperty uchar green\nproperty uchar blue\n" +
                           points + "0 1 255 0 0\n1 2 0 255 0\n0 2 0 0 255\n")));
  EXPECT_EQ(coloured.offsets, (std::vector<std::uint64_t>{0, 2, 4, 6}));
  EXPECT_EQ(coloured.colors[3], Rgba(0, 1, 0, 1));
  EXPECT_THROW(read_lines(file("bad.ply", ply("", edges + points + "0 1\n1 3\n0 2\n"))),
               InputError);
  EXPECT_THROW(read_lines(file("neg.ply", ply("", edges + points + "0 1\n1 -1\n0 2\n"))),
               InputError);
}

TEST_F(UnitShapes, PlyPointsAloneAreNoLine) {
  try {
    read_lines(file("p.ply", ply("", "end_header\n0 0 0\n1 0 0\n0 1 0\n")));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("p.ply: the file holds no lines"));
  }
}

TEST_F(UnitShapes, PlyColoursHaveSeveralNames) {
  for (const auto& [type, names, values] : std::vector<std::array<std::string, 3>>{
           {"uchar", "diffuse_red diffuse_green diffuse_blue", "255 0 51"},
           {"uchar", "Red Green Blue", "255 0 51"},
           {"float", "r g b", "1 0 0.2"},
           {"ushort", "R G B", "65535 0 13107"}}) {
    std::string properties;
    for (std::size_t i = 0, end; i < names.size(); i = end + 1) {
      end = std::min(names.find(' ', i), names.size());
      properties += "property " + type + " " + names.substr(i, end - i) + "\n";
    }
    std::string rest = face;
    for (const char* x : {"0 0 0 ", "1 0 0 ", "0 1 0 "}) rest += x + values + "\n";
    const TriangleMesh mesh = read_mesh(file("c.ply", ply(properties, rest + "3 0 1 2\n")));
    ASSERT_EQ(mesh.colors.size(), 3u) << names;
    EXPECT_EQ(mesh.colors[1], Rgba(1, 0, 0.2f, 1)) << names;
    EXPECT_TRUE(mesh.scalars.empty()) << names;
  }
}

// "r" alone is a radius, say.
TEST_F(UnitShapes, OneChannelIsAScalar) {
  const TriangleMesh mesh = read_mesh(
      file("r.ply", ply("property uchar r\n", face + "0 0 0 9\n1 0 0 9\n0 1 0 9\n3 0 1 2\n")));
  EXPECT_TRUE(mesh.colors.empty());
  EXPECT_EQ(mesh.scalars.at("r")[0], 9);
}

TEST_F(UnitShapes, WhatVtkDrawsByIsAColour) {
  const TriangleMesh mesh = read_mesh(
      file("p.vtk", squares("POINT_DATA 6\nCOLOR_SCALARS mine 3\n1 0 0 1 0 0 1 0 0 1 0 0 0 1 0 0 "
                            "1 0\n")));
  EXPECT_EQ(mesh.colors.at(0), Rgba(1, 0, 0, 1));
  EXPECT_EQ(mesh.colors.at(5), Rgba(0, 1, 0, 1));
  const TriangleMesh vectors = read_mesh(file(
      "v.vtk", squares("POINT_DATA 6\nVECTORS v float\n1 0 0 1 0 0 1 0 0 1 0 0 0 1 0 0 1 0\n")));
  EXPECT_TRUE(vectors.colors.empty());
  EXPECT_TRUE(vectors.scalars.contains("v_x"));
}

TEST_F(UnitShapes, EveryCellHasItsColour) {
  const TriangleMesh mesh =
      read_mesh(file("c.vtk", squares("CELL_DATA 2\nCOLOR_SCALARS any 3\n1 0 0 0 0 1\n"
                                      "POINT_DATA 6\nSCALARS h float 1\nLOOKUP_TABLE default\n"
                                      "0 1 2 3 4 5\n")));
  ASSERT_EQ(mesh.triangles.size(), 4u);
  EXPECT_EQ(mesh.positions.size(), 8u);  // the two in the middle twice
  EXPECT_NEAR(testing::area_of(mesh), 2, 1e-14);
  for (std::size_t i = 0; i < 4; ++i)
    for (const std::uint32_t v : mesh.triangles[i])
      EXPECT_EQ(mesh.colors[v], i < 2 ? Rgba(1, 0, 0, 1) : Rgba(0, 0, 1, 1)) << i;
  for (std::size_t v = 0; v < 8; ++v)
    if (mesh.positions[v] == Vec3(2, 1, 0)) {
      EXPECT_EQ(mesh.scalars.at("h")[v], 5);
    }
}

TEST_F(UnitShapes, HiddenCellsAreNotDrawn) {
  const auto ghosts = [](const std::string& values) {
    return "FIELD f 1\nvtkGhostType 1 " + std::to_string(values.size() / 2) + " unsigned_char\n" +
           values + "\n";
  };
  EXPECT_NEAR(testing::area_of(read_mesh(file("all.vtk", cubes("")))), 10, 1e-14);
  for (const char* flag : {"0 32", "0 1 "}) {  // hidden, duplicated
    const std::string marks =
        "CELL_DATA 2\nFIELD f 1\nvtkGhostType 1 2 unsigned_char\n" + std::string(flag) + "\n";
    // A duplicate is another piece's, so that the face between is within the whole.
    const double faces = std::string(flag) == "0 32" ? 6 : 5;
    const TriangleMesh cube = read_mesh(file("cube.vtk", cubes(marks)));
    EXPECT_NEAR(testing::area_of(cube), faces, 1e-14) << flag;
    EXPECT_FALSE(cube.face_scalars.contains("vtkGhostType"));
    const TriangleMesh square = read_mesh(file("square.vtk", squares(marks)));
    EXPECT_NEAR(testing::area_of(square), 1, 1e-14) << flag;
    EXPECT_FALSE(square.scalars.contains("vtkGhostType"));
  }
  const std::string hidden_point = "POINT_DATA 6\n" + ghosts("0 0 0 0 0 2 ");
  const fs::path path = file("point.vtk", squares(hidden_point));
  EXPECT_NEAR(testing::area_of(read_mesh(path)), 1, 1e-14);
  EXPECT_EQ(read_points(path).positions.size(), 5u);
}

TEST_F(UnitShapes, PointsOfHiddenVertexCellsAreNotDrawn) {
  const auto places = [&](const std::string& cells, const std::string& marks) {
    std::vector<double> x;
    const fs::path path = file("a.vtk",
                               "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\n"
                               "POINTS 5 float\n0 0 0 1 0 0 2 0 0 3 0 0 4 0 0\nVERTICES " +
                                   cells + marks);
    const PointSet points = read_points(path);
    for (const Vec3& position : points.positions) x.push_back(position.x);
    EXPECT_EQ(points.scalars.at("c").size(), x.size());
    return x;
  };
  const auto data = [](const std::string& count, const std::string& c, const std::string& marks) {
    return "CELL_DATA " + count + "\nSCALARS c float 1\nLOOKUP_TABLE default\n" + c +
           "\nFIELD f 1\nvtkGhostType 1 " + count + " unsigned_char\n" + marks + "\n";
  };
  const std::string each = "5 10\n1 0\n1 1\n1 2\n1 3\n1 4\n";
  EXPECT_THAT(places(each, data("5", "0 1 2 3 4", "0 32 1 0 0")), ElementsAre(0, 3, 4));
  // A point that another cell shows is drawn.
  EXPECT_THAT(places("4 10\n2 0 1\n1 1\n2 2 3\n1 4\n", data("4", "5 6 7 8", "1 0 0 0")),
              ElementsAre(1, 2, 3, 4));
  EXPECT_THAT(read_points(folder_ / "a.vtk").scalars.at("c"), ElementsAre(6, 7, 7, 8));
}

/// One cell of a vertex each; `components` numbers at it, 0, 1, 2, …
std::string rows_vtp(int components) {
  std::string values;
  for (int c = 0; c < components; ++c) values += fmt::format("{} ", c);
  return fmt::format(
      R"(<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian"><PolyData>
<Piece NumberOfPoints="1" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="0">
<PointData><DataArray type="Float32" Name="T" NumberOfComponents="{}" format="ascii">{}</DataArray>
</PointData><Points><DataArray type="Float32" NumberOfComponents="3" format="ascii">0 0 0</DataArray>
</Points></Piece></PolyData></VTKFile>)",
      components, values);
}

TEST_F(UnitShapes, EveryComponentOfATensorIsAScalar) {
  const auto scalars = [&](int components) {
    return read_points(file("t.vtp", rows_vtp(components))).scalars;
  };
  const auto tensor = scalars(9);
  EXPECT_EQ(tensor.size(), 9u);
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      EXPECT_EQ(tensor.at(fmt::format("T_{}{}", "xyz"[row], "xyz"[column])).front(),
                3 * row + column);
  EXPECT_EQ(scalars(6).at("T_xz").front(), 5);
  EXPECT_EQ(scalars(2).at("T_y").front(), 1);
  EXPECT_EQ(scalars(12).at("T_11").front(), 11);
}

}  // namespace
}  // namespace pellucid::geometry
