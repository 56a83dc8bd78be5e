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
}

}  // namespace
}  // namespace pellucid::compare
