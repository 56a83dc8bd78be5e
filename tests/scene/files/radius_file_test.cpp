// SPDX-License-Identifier: GPL-3.0-or-later
// Radii of a scene file: one, or those that a scalar gives; and what is refused.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "geometry/files/mesh_file.h"
#include "tests/scene/files/scene_file_folder.h"

namespace pellucid::scene {
namespace {

using ::testing::HasSubstr;

class UnitRadiusFile : public testing::SceneFileTest {
 protected:
  void SetUp() override {
    SceneFileTest::SetUp();
    write("lines.vtp", {0.5, 0, 2});
  }

  void write(const char* name, const std::vector<double>& thickness) const {
    geometry::LineSet lines;
    lines.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
    lines.offsets = {0, 3};
    lines.scalars = {{"thickness", thickness}, {"speed", {1, 1, 1}}};
    geometry::write_lines(folder_ / name, lines);
  }
};

TEST_F(UnitRadiusFile, AScalarGivesTheRadiusOfEachPoint) {
  const Scene scene = with(
      R"({"lines": "lines.vtp", "radius": {"by": "thickness", "scale": 0.5}, "profile": "tube"},
         {"lines": "lines.vtp", "radius": {"by": "thickness"}},
         {"points": "sheet.ply", "radius": {"by": "speed", "scale": 0.25}},
         {"lines": "lines.vtp", "radius": {"by": "speed", "scale": 0.3}})");
  const auto expect = [&](std::size_t object, const std::vector<double>& radii) {
    ASSERT_EQ(scene.objects[object].vertices().positions.size(), radii.size());
    for (std::size_t i = 0; i < radii.size(); ++i)
      EXPECT_EQ(scene.objects[object].radii().at(i), radii[i]) << object << ' ' << i;
  };
  expect(0, {0.25, 0, 1});
  expect(1, {0.5, 0, 2});
  expect(2, {0, 0.25, 0.5, 1});
  expect(3, {0.3, 0.3, 0.3});
  EXPECT_TRUE(scene.objects[0].radii().vary());
  EXPECT_EQ(scene.objects[3].radii(), Radii(0.3));  // and takes no memory
}

TEST_F(UnitRadiusFile, WhatIsIntegratedHasScalarsToo) {
  const Scene scene = with(
      R"({"lines": {"field": "formula:u=1,v=0,w=0", "integrator": "stream-lines:particles=5",
                    "seed": {"from": [0, 0, 0], "to": [0, 1, 0]}, "duration": 2},
          "radius": {"by": "t", "scale": 0.1}})");
  const geometry::Vertices& lines = scene.objects[0].vertices();
  for (std::size_t i = 0; i < lines.positions.size(); ++i)
    EXPECT_NEAR(scene.objects[0].radii().at(i), 0.1 * lines.positions[i].x, 1e-9);
}

// An array of the field's file: p is 1 + x.
TEST_F(UnitRadiusFile, AnArrayOfTheFieldsFileIsCarriedAlong) {
  std::ofstream(folder_ / "flow.vti") << R"(<VTKFile type="ImageData" byte_order="LittleEndian">
<ImageData WholeExtent="0 1 0 1 0 1" Origin="0 0 0" Spacing="4 1 1"><Piece Extent="0 1 0 1 0 1"><PointData>
<DataArray type="Float32" Name="v" NumberOfComponents="3" format="ascii">
1 0 0 1 0 0 1 0 0 1 0 0 1 0 0 1 0 0 1 0 0 1 0 0</DataArray>
<DataArray type="Float32" Name="p" format="ascii">1 5 1 5 1 5 1 5</DataArray>
</PointData></Piece></ImageData></VTKFile>)";
  const Scene scene = with(
      R"({"lines": {"field": "flow.vti:array=v", "integrator": "stream-lines:particles=2",
                    "seed": {"from": [1, 0.25, 0.5], "to": [1, 0.75, 0.5]}, "duration": 1},
          "radius": {"by": "p", "scale": 0.5}})");
  const geometry::Vertices& lines = scene.objects[0].vertices();
  ASSERT_GT(lines.positions.size(), 3u);
  for (std::size_t i = 0; i < lines.positions.size(); ++i)
    EXPECT_NEAR(scene.objects[0].radii().at(i), 0.5 * (1 + lines.positions[i].x), 1e-6);
}

// 0 at the middle point: to both sides it is as far as what is drawn of the others.
TEST_F(UnitRadiusFile, TheSceneIsAsLargeAsWhatIsDrawn) {
  const Scene scene = with(R"({"lines": "lines.vtp", "radius": {"by": "thickness"}})");
  const Box3 box = scene.bounds();
  EXPECT_EQ(box.min, Vec3(-1, -1, -2));
  EXPECT_EQ(box.max, Vec3(3, 3, 2));
}

TEST_F(UnitRadiusFile, AnUnknownScalarIsToldWhichThereAre) {
  EXPECT_THAT(refusal(R"({"lines": "lines.vtp", "radius": {"by": "thick"}})"),
              HasSubstr("scene.json: objects[0].radius.by: unknown scalar 'thick'; known: "
                        "thickness, speed"));
  EXPECT_THAT(refusal(R"({"lines": "lines.vtp", "radius": {"of": "thickness"}})"),
              HasSubstr("objects[0].radius: unknown key 'of'; known: by, scale"));
  EXPECT_THAT(refusal(R"({"lines": "lines.vtp", "radius": {"by": "speed", "scale": 0}})"),
              HasSubstr("objects[0].radius.scale: 0; accepted: a number above 0"));
  EXPECT_THAT(refusal(R"({"lines": "lines.vtp", "radius": {"by": "speed", "scale": -1}})"),
              HasSubstr("objects[0].radius.scale: -1"));
  EXPECT_THAT(refusal(R"({"mesh": "sheet.ply", "radius": {"by": "speed"}})"),
              HasSubstr("only lines and points have one"));
}

TEST_F(UnitRadiusFile, ValuesThatAreNoRadiusAreNamedByTheirFirstVertex) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const auto& [value, text] : {std::pair(-0.5, "-0.5"), std::pair(std::nan(""), "nan"),
                                    std::pair(infinity, "inf"), std::pair(1e300, "1e+300")}) {
    write("bad.vtp", {1, value, value});
    EXPECT_THAT(refusal(R"({"lines": "bad.vtp", "radius": {"by": "thickness"}})"),
                HasSubstr(std::string("objects[0].radius.by: 'thickness' is ") + text +
                          " at vertex 1; accepted: 0 or more"))
        << text;
  }
  write("large.vtp", {1, 2e299, 1});
  EXPECT_THAT(refusal(R"({"lines": "large.vtp", "radius": {"by": "thickness", "scale": 10}})"),
              HasSubstr("'thickness' is 2e+299 at vertex 1"));
  write("thin.vtp", {0, 0, 0});
  EXPECT_THAT(refusal(R"({"lines": "thin.vtp", "radius": {"by": "thickness"}})"),
              HasSubstr("'thickness' is 0 everywhere"));
}

}  // namespace
}  // namespace pellucid::scene
