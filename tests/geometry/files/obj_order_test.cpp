// SPDX-License-Identifier: GPL-3.0-or-later
// Statements of OBJ in any order, and lines that end as they did on other systems.

#include "tests/geometry/files/format_files.h"

namespace pellucid::geometry {
namespace {

using ::testing::HasSubstr;
using UnitObjOrder = FormatFiles;

const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

TEST_F(UnitObjOrder, FacesMayStandBeforeWhatTheyName) {
  const TriangleMesh mesh =
      read_mesh(file("a.obj", "f 1//1 2//1 3//1\n" + vertices + "vn 0 0 1\nf -3 -2 -1\n"));
  EXPECT_EQ(mesh.triangles[0], (std::array<std::uint32_t, 3>{0, 1, 2}));
  EXPECT_EQ(mesh.normals[0], Vec3(0, 0, 1));
  EXPECT_EQ(mesh.triangles.size(), 2u);
  const LineSet lines = read_lines(file("b.obj", "l 1/1 3/2\nvt 5\nvt 6\n" + vertices));
  EXPECT_EQ(lines.positions[1], Vec3(0, 1, 0));
  EXPECT_EQ(lines.scalars.at("attribute0"), (std::vector<double>{5, 6}));
}

TEST_F(UnitObjOrder, WhatIsListedNowhereIsRefusedWithItsLine) {
  const auto said = [&](const std::string& text) {
    return refusal([&] { read_mesh(file("a.obj", text)); });
  };
  EXPECT_THAT(said(vertices + "f 1 2 3\nf 1 2 4\nf 1 2 3\n"),
              HasSubstr("a.obj:5: vertex index 4, but 3 are listed"));
  EXPECT_THAT(said(vertices + "f 1//2 2//1 3//1\nvn 0 0 1\n"),
              HasSubstr("a.obj:4: normal index 2, but 1 are listed"));
  EXPECT_THAT(said("f -1 -2 -3\n" + vertices),
              HasSubstr("vertex index -1, but 0 were listed so far"));
  for (const char* wrong : {"0", "1.5", "4294967296", "nan", "-4"})
    EXPECT_THAT(said(vertices + "f 1 2 " + wrong + "\n"), HasSubstr("a.obj:4: vertex index"))
        << wrong;
}

TEST_F(UnitObjOrder, LinesEndInEveryWay) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    std::string text = vertices + "# a comment\n\nf 1 2 \\\n3\n";
    for (std::size_t at = 0; (at = text.find('\n', at)) != text.npos; at += end.size())
      text.replace(at, 1, end);
    EXPECT_EQ(read_mesh(file("a.obj", text)).triangles.size(), 1u);
    EXPECT_THAT(refusal([&] { read_mesh(file("a.obj", text + "f 1 2 9")); }),
                HasSubstr("a.obj:8:"));
  }
}

TEST_F(UnitObjOrder, LinesOfOtherTextsDoSoToo) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    const auto with_ends = [&](std::string text) {
      for (std::size_t at = 0; (at = text.find('\n', at)) != text.npos; at += end.size())
        text.replace(at, 1, end);
      return text;
    };
    EXPECT_EQ(read_mesh(file("a.off", with_ends("OFF # a comment\n\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n"
                                                "3 0 1 2\n")))
                  .triangles.size(),
              1u);
    EXPECT_EQ(read_points(file("a.csv", with_ends("x,y,z,s\n\n1,2,3,4\n5,6,7,8"))).scalars.at("s"),
              (std::vector<double>{4, 8}));
    EXPECT_THAT(refusal([&] { read_points(file("a.csv", with_ends("x,y,z\n1,2,3\n1,2,a\n"))); }),
                HasSubstr("a.csv:3:"));
  }
}

}  // namespace
}  // namespace pellucid::geometry
