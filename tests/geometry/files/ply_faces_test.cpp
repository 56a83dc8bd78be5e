// SPDX-License-Identifier: GPL-3.0-or-later
// What a PLY file says of its faces, and what of it cannot be.

#include "tests/geometry/files/format_files.h"

namespace pellucid::geometry {
namespace {

using ::testing::HasSubstr;

class UnitPlyFaces : public FormatFiles {
 protected:
  /// A square of four vertices; `face` are the properties of its faces besides their corners.
  fs::path square(const std::string& face, const std::string& faces, const std::string& vertex = "",
                  const std::string& of_vertex = "", const std::string& count = "uchar") const {
    std::string text =
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
        "property float z\n" +
        vertex + "element face " + std::to_string(std::ranges::count(faces, '\n')) +
        "\nproperty list " + count + " int vertex_indices\n" + face + "end_header\n";
    for (const char* at : {"0 0 0", "1 0 0", "1 1 0", "0 1 0"}) text += at + of_vertex + "\n";
    return file("a.ply", text + faces);
  }
  static const inline std::string rgb =
      "property uchar red\nproperty uchar green\nproperty uchar blue\n";
};

TEST_F(UnitPlyFaces, ColoursAreFlat) {
  const TriangleMesh mesh =
      read_mesh(square(rgb, "4 0 1 2 3 255 0 0\n3 0 1 2 0 0 51\n3 0 2 3 255 0 0\n"));
  ASSERT_EQ(mesh.triangles.size(), 4u);  // the first face has two
  for (std::size_t i = 0; i < 4; ++i)
    for (const std::uint32_t corner : mesh.triangles[i])
      EXPECT_EQ(mesh.colors[corner], i == 2 ? Rgba(0, 0, 0.2f, 1) : Rgba(1, 0, 0, 1)) << i;
  EXPECT_EQ(mesh.positions.size(), 7u);  // four of red faces and three of the blue one
  EXPECT_EQ(mesh.positions[mesh.triangles[2][2]], Vec3(1, 1, 0));
}

TEST_F(UnitPlyFaces, OtherNumbersAreScalars) {
  const TriangleMesh mesh =
      read_mesh(square("property float quality\nproperty list uchar float texcoord\n",
                       "4 0 1 2 3 5 2 9 9\n3 0 1 2 -7 0\n"));
  EXPECT_EQ(mesh.face_scalars.at("quality"), (std::vector<double>{5, 5, -7}));
  EXPECT_TRUE(mesh.colors.empty());
  EXPECT_EQ(mesh.positions.size(), 4u);
}

TEST_F(UnitPlyFaces, ColoursOfVerticesComeFirst) {
  const TriangleMesh mesh = read_mesh(square(rgb, "4 0 1 2 3 255 0 0\n", rgb, " 0 255 0"));
  EXPECT_EQ(mesh.colors, std::vector<Rgba>(4, Rgba(0, 1, 0, 1)));
  EXPECT_EQ(mesh.remarks.size(), 1u);  // that the others are scalars
}

TEST_F(UnitPlyFaces, AnAlphaAloneIsOfLightGrey) {
  const Rgba grey(0.8f, 0.8f, 0.8f, 0.2f);
  EXPECT_EQ(read_mesh(square("", "4 0 1 2 3\n", "property uchar alpha\n", " 51")).colors,
            std::vector<Rgba>(4, grey));
  EXPECT_EQ(read_mesh(square("property uchar alpha\n", "4 0 1 2 3 51\n")).colors,
            std::vector<Rgba>(4, grey));
}

TEST_F(UnitPlyFaces, ListsHaveWholeLengths) {
  for (const auto& [length, count] :
       {std::pair("-1", "uchar"), std::pair("-1", "int"), std::pair("3.7", "uchar"),
        std::pair("nan", "float"), std::pair("inf", "float"), std::pair("-0.5", "float")})
    EXPECT_THAT(
        refusal([&, &length = length, &count = count] {
          read_mesh(square("", std::string(length) + " 0 1 2\n3 0 1 2\n", "", "", count));
        }),
        HasSubstr(std::string("a.ply:14: 'vertex_indices': a list of ") + length + " values"));
  EXPECT_EQ(read_mesh(square("", "3.0 0 1 2\n", "", "", "float")).triangles.size(), 1u);
  EXPECT_EQ(read_mesh(square("", "0\n3 0 1 2\n")).triangles.size(), 1u);
}

TEST_F(UnitPlyFaces, FacesMayStandBeforeTheirVertices) {
  const auto mesh = read_mesh(
      file("b.ply",
           "ply\nformat ascii 1.0\nelement face 2\nproperty list uchar int vertex_indices\n"
           "property float heat\nelement vertex 4\nproperty float x\nproperty float y\n"
           "property float z\nend_header\n3 0 1 2 5\n3 0 2 3 6\n"
           "0 0 0\n1 0 0\n1 1 0\n0 1 0\n"));
  ASSERT_EQ(mesh.triangles.size(), 2u);
  EXPECT_THAT(mesh.triangles[1], ::testing::ElementsAre(0, 2, 3));
  EXPECT_THAT(mesh.face_scalars.at("heat"), ::testing::ElementsAre(5, 6));
}

}  // namespace
}  // namespace pellucid::geometry
