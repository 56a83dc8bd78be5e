// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/sampled/cell_locator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace pellucid::fields {
namespace {

using Boxes = std::vector<Box3>;

CellLocator locator_of(const Boxes& boxes) {
  return {boxes.size(), [&](std::size_t i) { return boxes[i]; }};
}

Box3 box_around(const Vec3& center, const Vec3& width) {
  return {center - 0.5 * width, center + 0.5 * width};
}

Vec3 anywhere(std::mt19937& random) {
  std::uniform_real_distribution<double> any(0, 1);
  return {any(random), any(random), any(random)};
}

/// Cells of widths from 1 to a millionth, the smaller the nearer to a corner, as near a wall.
Boxes graded_boxes(int count) {
  std::mt19937 random(1);
  Boxes boxes;
  for (int i = 0; i < count; ++i) {
    const double scale = std::pow(10, -6 * anywhere(random).x);
    boxes.push_back(box_around(scale * anywhere(random), Vec3(0.05 * scale)));
  }
  return boxes;
}

/// Whether the list ascends and has all boxes that hold x.
void expect_all_that_hold(const Boxes& boxes, const CellLocator& locator, const Vec3& x) {
  const auto found = locator.cells_at(x);
  ASSERT_TRUE(std::ranges::adjacent_find(found, std::greater_equal<>()) == found.end());
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
    if (boxes[i].contains(x)) {
      ASSERT_TRUE(std::ranges::binary_search(found, i)) << i;
    }
}

TEST(PropertyCellLocator, ListsEveryBoxThatHoldsAPlace) {
  std::mt19937 random(2);
  Boxes boxes = graded_boxes(3000);
  for (int i = 0; i < 3000; ++i) {
    const Vec3 thin(i % 3 ? 0.1 : 0, i % 5 ? 0.02 : 0, i % 7 ? 0.3 : 0);  // planes and lines, too
    boxes.push_back(box_around(anywhere(random), thin));
  }
  const CellLocator locator = locator_of(boxes);
  for (const Box3& box : boxes)
    for (const Vec3& x : {box.min, box.center(), box.max}) expect_all_that_hold(boxes, locator, x);
  for (int i = 0; i < 300; ++i) expect_all_that_hold(boxes, locator, 2.0 * anywhere(random) - 0.5);
}

/// A single grid would have nearly all cells of the corner in one bin.
TEST(UnitCellLocator, ListsAreShortWhereCellsAreSmall) {
  const Boxes boxes = graded_boxes(100000);
  const CellLocator locator = locator_of(boxes);
  std::size_t listed = 0;
  for (const Box3& box : boxes) listed += locator.cells_at(box.center()).size();
  EXPECT_LT(double(listed) / double(boxes.size()), 64);
}

/// Grids within grids cannot part them, and give up at once.
TEST(UnitCellLocator, BoxesThatAllOverlapAreOneList) {
  const Boxes boxes(20000, box_around(Vec3(5), Vec3(2)));
  const CellLocator locator = locator_of(boxes);
  EXPECT_EQ(locator.cells_at(Vec3(5)).size(), boxes.size());
  EXPECT_TRUE(locator.cells_at(Vec3(7)).empty());
}

TEST(UnitCellLocator, LargeBoxesAmongSmallOnesKeepListsShort) {
  std::mt19937 random(3);
  Boxes boxes(1000, box_around(Vec3(0.5), Vec3(1)));
  for (int i = 0; i < 20000; ++i) boxes.push_back(box_around(anywhere(random), Vec3(0.02)));
  const CellLocator locator = locator_of(boxes);
  for (int i = 0; i < 100; ++i) {
    const Vec3 x = anywhere(random);
    expect_all_that_hold(boxes, locator, x);
    EXPECT_LT(locator.cells_at(x).size(), 1500u);
  }
}

TEST(UnitCellLocator, OneCellAndPlacesThatAreNone) {
  const Boxes boxes{box_around(Vec3(1e6), Vec3(1e-3))};
  const CellLocator locator = locator_of(boxes);
  EXPECT_EQ(locator.cells_at(Vec3(1e6)).size(), 1u);
  EXPECT_TRUE(locator.cells_at(Vec3(NAN, 1e6, 1e6)).empty());
  EXPECT_TRUE(locator.cells_at(Vec3(0)).empty());
}

}  // namespace
}  // namespace pellucid::fields
