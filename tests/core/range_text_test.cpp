// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/range_text.h"

#include <gtest/gtest.h>

#include <limits>

namespace pellucid {
namespace {

TEST(UnitRangeText, HasSixDigitsWhereTheyTellBothApart) {
  EXPECT_EQ(range_text(0, 1), "0 … 1");
  EXPECT_EQ(range_text(-1.0 / 3, 2e9), "-0.333333 … 2e+09");
  EXPECT_EQ(range_text(0.1, 0.1), "0.1 … 0.1");
}

TEST(UnitRangeText, HasMoreWhereTheyDoNot) {
  EXPECT_EQ(range_text(101325, 101325.04), "101325 … 101325.04");
  EXPECT_EQ(range_text(1e6, 1e6 + 0.1), "1000000 … 1000000.1");
  const double next = 1 + std::numeric_limits<double>::epsilon();
  EXPECT_EQ(range_text(1, next), "1 … 1.0000000000000002");
}

TEST(UnitRangeText, TakesWhatIsNoNumber) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(range_text(-infinity, infinity), "-inf … inf");
  EXPECT_EQ(range_text(0, std::numeric_limits<double>::quiet_NaN()), "0 … nan");
}

}  // namespace
}  // namespace pellucid
