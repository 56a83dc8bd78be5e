// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/geometry/files/format_files.h"

namespace pellucid::geometry {
namespace {

using ::testing::HasSubstr;
using UnitCsvHeads = FormatFiles;

TEST_F(UnitCsvHeads, CsvIsReadHoweverItIsHeaded) {
  for (const char* content :
       {"x,y,z,s\n1,2,3,4\n5,6,7,8\n", "\xEF\xBB\xBFx,y,z,s\n1,2,3,4\n5,6,7,8\n",
        "X,Y,Z,s\r\n1,2,3,4\r\n5,6,7,8\r\n",
        "\"s\",\"Points:0\",\"Points:1\",\"Points:2\"\n4,1,2,3\n8,5,6,7\n",
        "s,Points_0,Points_1,Points_2\n4,1,2,3\n8,5,6,7\n", "//X;Y;Z;s\n1;2;3;4\n5;6;7;8\n",
        "x\ty\tz\ts\n1\t2\t3\t4\n5\t6\t7\t8\n", "# made by x\nx,y,z,s\n1,2,3,4\n5,6,7,8\n\n",
        "x [m], y [m], z [m], s\n1, 2, 3, 4\n5 ,6, 7, 8\n", "x  y z s\n1 2  3 4\n 5 6 7 8 \n",
        "x;y;z;s\n1,0;2;3;4\n5;6,0;7;8\n",
        "x-coordinate, y-coordinate, z-coordinate, s\n1,2,3,4\n5,6,7,8\n"}) {
    const PointSet points = read_points(file("a.csv", content));
    EXPECT_EQ(points.positions, (std::vector<Vec3>{{1, 2, 3}, {5, 6, 7}})) << content;
    ASSERT_TRUE(points.scalars.contains("s")) << content;
    EXPECT_EQ(points.scalars.at("s"), (std::vector<double>{4, 8})) << content;
  }
}

TEST_F(UnitCsvHeads, CsvHasColoursInBytesOrShares) {
  const PointSet bytes = read_points(file("a.csv", "//X Y Z R G B\n0 0 0 255 0 51\n1 1 1 0 1 0\n"));
  EXPECT_EQ(bytes.colors[0], Rgba(1, 0, 0.2f, 1));
  EXPECT_EQ(bytes.colors[1], Rgba(0, 1 / 255.f, 0, 1));
  const PointSet shares =
      read_points(file("b.csv", "x,y,z,red,green,blue,alpha\n0,0,0,1,0,0.5,1\n1,1,1,0,1,0,0\n"));
  EXPECT_EQ(shares.colors[0], Rgba(1, 0, 0.5f, 1));
  EXPECT_EQ(shares.colors[1], Rgba(0, 1, 0, 0));
  const PointSet mixed = read_points(
      file("c.csv", "x,y,z,red,green,blue,alpha\n0,0,0,255,0,0,0.5\n1,1,1,0,255,0,1\n"));
  EXPECT_EQ(mixed.colors[0], Rgba(1, 0, 0, 0.5f));
}

TEST_F(UnitCsvHeads, ColumnsOfTextAreLeftOutAndNamed) {
  const PointSet points =
      read_points(file("a.csv", "x,y,z,\"name, in full\",s\n0,0,0,\"a, b\",4\n1,0,0,7,5\n"));
  EXPECT_EQ(points.scalars.size(), 1u);
  EXPECT_EQ(points.scalars.at("s"), (std::vector<double>{4, 5}));
  EXPECT_THAT(points.remarks,
              ::testing::ElementsAre("column 'name, in full' is text and is left out"));
}

TEST_F(UnitCsvHeads, AColumnOfTextMayBeTheFirst) {
  const PointSet points = read_points(file("a.csv", "name,x,y,z\nab,1,2,3\ncd,2,3,4\n"));
  EXPECT_EQ(points.positions, (std::vector<Vec3>{{1, 2, 3}, {2, 3, 4}}));
  EXPECT_THAT(points.remarks, ::testing::ElementsAre("column 'name' is text and is left out"));
}

TEST_F(UnitCsvHeads, CsvSaysWhichColumnOrLineIsWrong) {
  for (const auto& [content, said] :
       {std::pair("x,y,s\n0,0,1\n", "no columns x, y, z among x, y, s"),
        std::pair("x,y,z,s\n0,0,0,1\n1,0,0,\n", ":3: column 's': '': expected a number"),
        std::pair("x,y,z\n0,0,0\n1,0,0,5\n", ":3: more than the 3 columns"),
        std::pair("x,y,z,s\n0,0,0,1\n1,0,0,b\n", ":3: column 's': 'b'"),
        std::pair("x,y,z\n0,0,a\n", ":2: column 'z': 'a'"),
        std::pair("# x\n# y\n", "no line that names the columns"),
        std::pair("x,y,z\n1,5;2;3\n", "'5;2;3'")})
    EXPECT_THAT(refusal([&] { read_points(file("a.csv", content)); }), HasSubstr(said));
}

TEST_F(UnitCsvHeads, NamesThatAreThereTwiceAreRefused) {
  EXPECT_THAT(refusal([&] { read_points(file("a.csv", "x,y,z,s,s\n0,0,0,1,2\n")); }),
              HasSubstr("a.csv:1: two columns are called 's'"));
  EXPECT_THAT(refusal([&] { read_points(file("a.csv", "x,y,x,z\n0,0,0,1\n")); }),
              HasSubstr("two columns are called 'x'"));
}

TEST_F(UnitCsvHeads, PositionsAreOfOneUnit) {
  EXPECT_THAT(refusal([&] { read_points(file("a.csv", "x (mm),y (mm),z (cm)\n0,0,0\n")); }),
              HasSubstr("'z (cm)', but another axis is in mm"));
  for (const char* head :
       {"x (mm),y [mm],z ( mm ),s", "x (mm),y,z (mm),s", "x [m],y [m],z [m],s [cm]"})
    EXPECT_EQ(read_points(file("a.csv", std::string(head) + "\n1,2,3,4\n")).positions,
              std::vector<Vec3>(1, Vec3(1, 2, 3)));
}

}  // namespace
}  // namespace pellucid::geometry
