// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/options/split.h"

#include <gmock/gmock.h>

namespace pellucid {
namespace {

using ::testing::ElementsAre;

TEST(UnitSplit, KeepsEmptyParts) {
  EXPECT_THAT(split("", ','), ElementsAre(""));
  EXPECT_THAT(split("a", ','), ElementsAre("a"));
  EXPECT_THAT(split(",a,,b,", ','), ElementsAre("", "a", "", "b", ""));
}

TEST(UnitSplit, WithinParenthesesNothingParts) {
  EXPECT_THAT(split_outside_parentheses("u=pow(x,2),v=f(a,(b,c)),w", ','),
              ElementsAre("u=pow(x,2)", "v=f(a,(b,c))", "w"));
  EXPECT_THAT(split_outside_parentheses("", ','), ElementsAre(""));
}

}  // namespace
}  // namespace pellucid
