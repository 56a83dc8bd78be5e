// SPDX-License-Identifier: GPL-3.0-or-later
// Faces and lines of .obj have the colour and the opacity of their material.

#include <algorithm>

#include "core/files/files_read.h"
#include "tests/geometry/files/format_files.h"

namespace pellucid::geometry {
namespace {

using ::testing::AllOf;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr const char* corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";

class UnitObjMaterials : public FormatFiles {
 protected:
  TriangleMesh mesh_of(const std::string& statements) const {
    return read_mesh(file("a.obj", corners + statements));
  }
  /// The colour of one face whose material is `m`.
  Rgba color_of(const std::string& material) const {
    file("a.mtl", "newmtl m\n" + material);
    return mesh_of("mtllib a.mtl\nusemtl m\nf 1 2 3\n").colors.at(0);
  }
  std::string refusal_of(const std::string& material) const {
    file("a.mtl", "newmtl m\n" + material);
    return refusal([&] { mesh_of("mtllib a.mtl\nusemtl m\nf 1 2 3\n"); });
  }
};

TEST_F(UnitObjMaterials, AFaceHasTheColourAndTheOpacityOfItsMaterial) {
  file("a.mtl",
       "newmtl glass\nKd 1 0 0.5\nd 0.25\n\nnewmtl old paint # a name of two words\nKd 0\n");
  const TriangleMesh mesh =
      mesh_of("f 1 2 3\nmtllib a.mtl\nusemtl glass\nf 1 2 4 3\nusemtl old paint\nf 1 3 4\n");
  EXPECT_THAT(mesh.remarks, IsEmpty());
  ASSERT_EQ(mesh.triangles.size(), 4u);
  ASSERT_EQ(mesh.colors.size(), mesh.positions.size());
  const Rgba grey(0.8f, 0.8f, 0.8f, 1), glass(1, 0, 0.5f, 0.25f), black(0, 0, 0, 1);
  const Rgba expected[] = {grey, glass, glass, black};
  for (std::size_t i = 0; i < 4; ++i)
    for (const std::uint32_t corner : mesh.triangles[i])
      EXPECT_EQ(mesh.colors[corner], expected[i]) << i;
  EXPECT_EQ(mesh.positions[mesh.triangles[3][2]], Vec3(0, 0, 1));
}

/// A study's rows are of it, too: once it is there, they are others.
TEST_F(UnitObjMaterials, AFileThatIsMissingIsAmongWhatIsRead) {
  const FilesRead files;
  mesh_of("mtllib later.mtl\nusemtl m\nf 1 2 3\n");
  const auto paths = files.paths();
  EXPECT_TRUE(
      std::ranges::any_of(paths, [](const auto& p) { return p.filename() == "later.mtl"; }));
}

TEST_F(UnitObjMaterials, OpacityIsDOrWhatTrLeaves) {
  EXPECT_EQ(color_of("Tr 0.75\n").a, 0.25f);
  EXPECT_EQ(color_of("Tr 0.5\nd 0.25\n").a, 0.25f);  // d is the format's own
  EXPECT_EQ(color_of("d 0.25\nTr 0.5\n").a, 0.25f);
  EXPECT_EQ(color_of("Kd 0.5 1 0\n"), Rgba(0.5f, 1, 0, 1));
  EXPECT_EQ(color_of("Ns 9\nd 0\n"), Rgba(0.8f, 0.8f, 0.8f, 0));
}

TEST_F(UnitObjMaterials, LinesHaveThemToo) {
  file("a.mtl", "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\nd 0.5\n");
  const LineSet lines = read_lines(file(
      "a.obj", std::string(corners) + "mtllib a.mtl\nusemtl red\nl 1 2\nusemtl blue\nl 2 3 4\n"));
  const Rgba red(1, 0, 0, 1), blue(0, 0, 1, 0.5f);
  EXPECT_THAT(lines.colors, ElementsAre(red, red, blue, blue, blue));
}

TEST_F(UnitObjMaterials, SeveralFilesMayHaveThem) {
  file("a b.mtl", "newmtl one\nKd 1 0 0\n");
  file("c.mtl", "newmtl two\nKd 0 1 0\n");
  file("d.mtl", "newmtl three\nKd 0 0 1\n");
  const TriangleMesh mesh = mesh_of(
      "mtllib a b.mtl\nmtllib c.mtl d.mtl\nusemtl one\nf 1 2 3\nusemtl two\nf 1 2 4\n"
      "usemtl three\nf 1 3 4\n");
  ASSERT_EQ(mesh.colors.size(), 9u);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(mesh.colors[mesh.triangles[std::size_t(i)][0]][i], 1.f);
}

TEST_F(UnitObjMaterials, WhatIsNotDrawnAsTheFilesSayIsSaid) {
  EXPECT_THAT(mesh_of("mtllib none.mtl\nusemtl m\nf 1 2 3\n").remarks,
              ElementsAre(AllOf(HasSubstr("mtllib: "), HasSubstr("none.mtl: cannot read")),
                          "no .mtl file has the material 'm': light grey, opaque"));
  EXPECT_THAT(mesh_of("usemtl m\nf 1 2 3\nusemtl n\nf 1 2 4\n").remarks,
              ElementsAre("no .mtl file has the material 'm' and 1 more: light grey, opaque"));
  EXPECT_EQ(color_of("map_Kd wood.png\nKd 1 1 1\n"), Rgba(1));
  EXPECT_THAT(mesh_of("mtllib a.mtl\nusemtl m\nf 1 2 3\n").remarks,
              ElementsAre("materials say more than is read, textures are not: map_Kd of the "
                          "material 'm'"));
  const TriangleMesh colored = read_mesh(file(
      "a.obj", "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0 1 0 0\nmtllib a.mtl\nusemtl m\nf 1 2 3\n"));
  EXPECT_THAT(colored.colors, Each(Rgba(1, 0, 0, 1)));
  EXPECT_THAT(colored.remarks,
              ElementsAre("its materials are passed over: the vertices have colours"));
}

TEST_F(UnitObjMaterials, NumbersThatAreNoneAreRefusedWithBothLines) {
  for (const char* wrong : {"Kd 1 0\n", "Kd red\n", "Kd 1 0 1.5\n", "d\n", "d -1\n", "Tr nan\n"})
    EXPECT_THAT(refusal_of(wrong), AllOf(HasSubstr("a.obj:5: mtllib: "), HasSubstr("a.mtl:2: "),
                                         HasSubstr("accepted: numbers in 0 … 1")))
        << wrong;
}

TEST_F(UnitObjMaterials, SevenNumbersEndWithAnAlphaOrBeginTheColourWithAWeight) {
  const TriangleMesh alphas = read_mesh(
      file("a.obj", "v 0 0 0 0.25 0.5 0.75 0.5\nv 1 0 0 1 0 0 1\nv 0 1 0 1 0 0 0\nf 1 2 3\n"));
  EXPECT_EQ(alphas.colors,
            (std::vector<Rgba>{{0.25f, 0.5f, 0.75f, 0.5f}, {1, 0, 0, 1}, {1, 0, 0, 0}}));
  EXPECT_THAT(alphas.remarks,
              ::testing::ElementsAre("3 vertices of seven numbers are read as x y z red green blue "
                                     "alpha"));
  const TriangleMesh weights = read_mesh(
      file("b.obj", "v 0 0 0 1 0.25 0.5 0.75\nv 1 0 0 1 1 0 0\nv 0 1 0 1 0 0 0.5\nf 1 2 3\n"));
  EXPECT_EQ(weights.colors,
            (std::vector<Rgba>{{0.25f, 0.5f, 0.75f, 1}, {1, 0, 0, 1}, {0, 0, 0.5f, 1}}));
  EXPECT_THAT(weights.remarks, ::testing::ElementsAre(HasSubstr("read as x y z w red green blue")));
}

TEST_F(UnitObjMaterials, FreeFormsAreLeftOutAndNamed) {
  const TriangleMesh mesh =
      read_mesh(file("a.obj",
                     "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\ncstype bezier\ndeg 1 1\n"
                     "surf 0 1 0 1 1 2 3 4\nparm u 0 1\nparm v 0 1\nend\ncurv 0 1 1 2\nend\n"));
  EXPECT_EQ(mesh.triangles.size(), 1u);
  EXPECT_THAT(mesh.remarks, ::testing::ElementsAre(HasSubstr("2 free-form curves and surfaces")));
}

}  // namespace
}  // namespace pellucid::geometry
