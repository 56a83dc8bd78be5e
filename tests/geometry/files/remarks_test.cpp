// SPDX-License-Identifier: GPL-3.0-or-later
// What a reader mended or left out it says: a grey or oddly lit picture has a reason to be found.

#include <sstream>

#include "geometry/files/color_names.h"
#include "tests/geometry/files/format_files.h"

namespace pellucid::geometry {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using UnitRemarks = FormatFiles;

std::string points_ply(const std::string& properties, const std::string& vertices) {
  return "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
         "property float z\n" +
         properties + "element face 1\nproperty list uchar int vertex_indices\nend_header\n" +
         vertices + "3 0 1 2\n";
}

TEST_F(UnitRemarks, NormalsThatAreNoneAreCounted) {
  const std::string normals = "property float nx\nproperty float ny\nproperty float nz\n";
  const auto remarks = [&](const std::string& vertices) {
    return read_mesh(file("a.ply", points_ply(normals, vertices))).remarks;
  };
  EXPECT_THAT(remarks("0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n"), IsEmpty());
  EXPECT_THAT(remarks("0 0 0 0 0 1\n1 0 0 0 0 0\n0 1 0 nan 0 1\n"),
              ElementsAre("2 of 3 vertices have no normal of their own and get their facets'"));
  EXPECT_THAT(remarks("0 0 0 0 0 0\n1 0 0 0 0 0\n0 1 0 0 0 0\n"),
              ElementsAre(HasSubstr("3 of 3 vertices")));
}

TEST_F(UnitRemarks, ASecondFamilyOfColoursIsNamed) {
  const std::string both =
      "property uchar red\nproperty uchar green\nproperty uchar blue\n"
      "property uchar diffuse_red\nproperty uchar diffuse_green\nproperty uchar diffuse_blue\n";
  const TriangleMesh mesh = read_mesh(
      file("a.ply",
           points_ply(both, "0 0 0 255 0 0 1 2 3\n1 0 0 255 0 0 1 2 3\n0 1 0 255 0 0 1 2 3\n")));
  EXPECT_EQ(mesh.colors[0], Rgba(1, 0, 0, 1));
  EXPECT_THAT(mesh.remarks,
              ElementsAre("'diffuse_red diffuse_green diffuse_blue' is called as colours are, and "
                          "is read as scalars: the colours are another array's"));
}

TEST_F(UnitRemarks, AnAlphaOfBytesGoesWithAnyFamilyOfColours) {
  for (const char* names : {"diffuse_red diffuse_green diffuse_blue alpha", "r g b alpha"}) {
    std::string properties;
    std::istringstream words(names);
    for (std::string name; words >> name;) properties += "property uchar " + name + "\n";
    const TriangleMesh mesh = read_mesh(file(
        "a.ply", points_ply(properties, "0 0 0 255 0 0 51\n1 0 0 255 0 0 51\n0 1 0 255 0 0 51\n")));
    EXPECT_EQ(mesh.colors, std::vector<Rgba>(3, Rgba(1, 0, 0, 0.2f)));
    EXPECT_THAT(mesh.remarks, IsEmpty());
  }
}

/// Colours in 0 … 255 that are not bytes: which unit they have, the file does not say.
TEST_F(UnitRemarks, ColoursOfNoKnownUnitAreNamed) {
  const PointSet points = read_points(
      file("a.vtp", R"(<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian"><PolyData>
<Piece NumberOfPoints="1" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="0">
<PointData><DataArray type="Float32" Name="my colour" NumberOfComponents="3" format="ascii">255 0 9
</DataArray></PointData><Points><DataArray type="Float32" NumberOfComponents="3" format="ascii">
0 0 0</DataArray></Points></Piece></PolyData></VTKFile>)"));
  EXPECT_THAT(points.colors, IsEmpty());
  EXPECT_THAT(points.remarks, ElementsAre("'my colour' is called as colours are, and is read as "
                                          "scalars: colours are bytes or numbers in [0, 1]"));
}

/// Two vertex cells: of the first point, and of the other two.
TEST_F(UnitRemarks, PointsHaveTheScalarsOfTheirVertexCells) {
  const auto text = [](const std::string& ends) {
    return R"(<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian"><PolyData>
<Piece NumberOfPoints="3" NumberOfVerts="2" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="0">
<CellData><DataArray type="Float64" Name="c" format="ascii">10 20</DataArray></CellData>
<Points><DataArray type="Float32" NumberOfComponents="3" format="ascii">
0 0 0 1 0 0 2 0 0</DataArray></Points><Verts>
<DataArray type="Int64" Name="connectivity" format="ascii">2 0 1</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">)" +
           ends + R"(</DataArray></Verts></Piece></PolyData></VTKFile>)";
  };
  EXPECT_THAT(read_points(file("v.vtp", text("1 3"))).scalars.at("c"), ElementsAre(20, 20, 10));
  EXPECT_THAT(read_points(file("v.vtp", text("2 3"))).scalars.at("c"), ElementsAre(10, 20, 10));
  // The last point is of no cell.
  EXPECT_THAT(read_points(file("v.vtp", text("1 2"))).scalars, IsEmpty());
}

TEST_F(UnitRemarks, OtherNamesAreNoColours) {
  EXPECT_THAT(untaken_colors({"v_x", "v_y", "v_z", "color_x", "r", "g", "speed"}), IsEmpty());
  EXPECT_THAT(untaken_colors({"Color_x", "Color_y", "Color_z", "a", "b", "g", "r"}),
              ElementsAre("Color", "r g b a"));
}

}  // namespace
}  // namespace pellucid::geometry
