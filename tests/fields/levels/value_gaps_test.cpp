// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/levels/value_gaps.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace pellucid::fields {
namespace {

TEST(UnitValueGaps, LowEndsAreNotPartOfThemAndHighEndsAre) {
  ValueGaps gaps;
  gaps.add(1, 2);
  EXPECT_FALSE(gaps.contains(1));
  EXPECT_TRUE(gaps.contains(1.5));
  EXPECT_TRUE(gaps.contains(2));
  EXPECT_FALSE(gaps.contains(2.1));
  gaps.add(5, 5);  // of equal samples no value lies between
  EXPECT_FALSE(gaps.contains(5));
}

TEST(UnitValueGaps, AreTheUnionOfWhatIsAdded) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> end(0, 40);
  for (int round = 0; round < 200; ++round) {
    ValueGaps gaps;
    std::vector<Vec2> added(std::size_t(round % 9));
    for (Vec2& gap : added) {
      gap = {end(random), end(random)};
      gaps.add(gap.x, gap.y);
    }
    for (double value = -0.5; value < 41; value += 0.5) {
      bool any = false;
      for (const Vec2& gap : added) any |= gap.x < value && value <= gap.y;
      EXPECT_EQ(gaps.contains(value), any) << value;
    }
  }
}

TEST(UnitValueGaps, SayWhatRemains) {
  ValueGaps gaps;
  EXPECT_EQ(gaps.accepted({0.1f, 101325.0085}), "from 0.1 to 101325.0085");
  gaps.add(-9, -0.5);
  gaps.add(0.25, 9);
  EXPECT_EQ(gaps.accepted({-1, 1}), "above -0.5 to 0.25");
  gaps.add(0, 0.125);
  EXPECT_EQ(gaps.accepted({-1, 1}), "above -0.5 to 0 or above 0.125 to 0.25");
  EXPECT_EQ(gaps.accepted({1, 2}), "none");
}

}  // namespace
}  // namespace pellucid::fields
