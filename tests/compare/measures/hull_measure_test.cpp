// SPDX-License-Identifier: GPL-3.0-or-later
// Pixels outside the hull of what may be drawn there.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/compare/measures/measured.h"
#include "tests/support/scenes.h"

namespace pellucid::compare {
namespace {

using namespace pellucid::testing;
using namespace pellucid::compare::testing;

/// A red and a green layer over blue.
scene::Scene red_green_blue() {
  scene::Scene scene =
      stack(2, 4, 3, [](int i) { return i == 0 ? Rgba(1, 0, 0, 0.5) : Rgba(0, 1, 0, 0.5); });
  scene.background = {0, 0, 1};
  return scene;
}

TEST(UnitHullMeasure, CountsThePixelsThatLeaveTheHull) {
  const scene::Scene scene = red_green_blue();
  CellMeasurement cell = picture_of(scene, Rgba(0.2, 0.3, 0.5, 1));
  // Along the normal of the plane r + g + b = 1, on which the hull lies.
  cell.image.at(2, 1) = Rgba(0.2 + 0.1, 0.3 + 0.1, 0.5 + 0.1, 1);
  hull_measure().measure(seen(scene, {}), cell);
  EXPECT_EQ(cell.row.measures[0].value, 1);
  // Three channels of a picture in float, 3e-8 each, and the projection's 1e-7.
  EXPECT_NEAR(cell.row.measures[1].value, 0.1 * std::sqrt(3.0), 2e-7);
  ASSERT_EQ(cell.further.size(), 1u);
  EXPECT_NE(cell.further[0].at(2, 1), cell.further[0].at(0, 0));
}

// The exact composite of red, green and blue at (0.2, 0.3, 0.5), as far as 8 bits have it, lies off
// the hull's plane by up to √3 / 2 of their steps.
TEST(UnitHullMeasure, RoundingTo8BitsLeavesNoHull) {
  const scene::Scene scene = red_green_blue();
  CellMeasurement cell = picture_of(scene, Rgba(51 / 255.f, 77 / 255.f, 128 / 255.f, 1));
  cell.row.given = "picture";
  hull_measure().measure(seen(scene, {}), cell);
  EXPECT_EQ(cell.row.measures[0].value, 0);
  EXPECT_LT(cell.row.measures[1].value, 1e-6);
}

TEST(UnitHullMeasure, AFullChannelStandsForAllThatIsCutOff) {
  scene::Scene scene = stack(1, 4, 3, [](int) { return Rgba(3, 1, 1, 0.5); });
  scene.background = {0, 0, 0};
  // (1.5, 0.5, 0.5), shown as (1, 0.5, 0.5).
  CellMeasurement cell = picture_of(scene, Rgba(1, 128 / 255.f, 128 / 255.f, 1));
  hull_measure().measure(seen(scene, {}), cell);
  EXPECT_EQ(cell.row.measures[0].value, 12);  // of a picture in float it is off
  CellMeasurement given = picture_of(scene, Rgba(1, 128 / 255.f, 128 / 255.f, 1));
  given.row.given = "picture";
  hull_measure().measure(seen(scene, {}), given);
  EXPECT_EQ(given.row.measures[0].value, 0);
}

TEST(UnitHullMeasure, LeavesOutPixelsWhoseLayersDiffer) {
  const scene::Scene scene = red_green_blue();
  CellMeasurement cell = picture_of(scene, Rgba(2, 2, 2, 1));
  cell.layers = CountImage(4, 3, 2);
  cell.layers.at(0, 0) = 1;
  hull_measure().measure(seen(scene, {}), cell);
  EXPECT_EQ(cell.row.measures[0].value, 11);
  CellMeasurement none = picture_of(scene, Rgba(2, 2, 2, 1));
  none.layers = CountImage(4, 3, 1);
  hull_measure().measure(seen(scene, {}), none);  // nothing is known, which is not 0
  EXPECT_TRUE(none.row.measures.empty());
}

/// A red sheet that ends, and a green one that begins, so many pixels to the right of the centres
/// of column 1, over blue.
scene::Scene red_beside_green(double beside) {
  scene::Scene scene = empty_scene(4, 4);
  scene.background = {0, 0, 1};
  const double edge = -0.25 + beside * 0.5;
  scene.objects = {{"red", rectangle(-9, edge, -9, 9, 0, Rgba(1, 0, 0, 0.5))},
                   {"green", rectangle(edge, 9, -9, 9, 0, Rgba(0, 1, 0, 0.5))}};
  return scene;
}

// What a rasterizer that snaps the edge to 1/256 of a pixel draws there is green, of one layer as
// well; farther off it is wrong.
TEST(UnitHullMeasure, ColoursAtAnEdgeAreThoseOfEitherSide) {
  for (const double beside : {0.9 / 256, 1.1 / 256}) {
    const scene::Scene scene = red_beside_green(beside);
    CellMeasurement cell = picture_of(scene, Rgba(0.5, 0, 0.5, 1));
    for (int y = 0; y < 4; ++y)
      for (int x = 1; x < 4; ++x) cell.image.at(x, y) = Rgba(0, 0.5, 0.5, 1);
    cell.layers = CountImage(4, 4, 1);
    hull_measure().measure(seen(scene, {}), cell);
    EXPECT_EQ(cell.row.measures[0].value, beside < 1. / 256 ? 0 : 4);
  }
}

}  // namespace
}  // namespace pellucid::compare
