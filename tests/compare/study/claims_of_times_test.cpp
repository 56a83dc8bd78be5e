// SPDX-License-Identifier: GPL-3.0-or-later
// Claims about times: what intervals decide, and what they leave open.
#include <gmock/gmock.h>

#include "tests/compare/study/checked_claims.h"

namespace pellucid::compare {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A row whose time is in this interval, its median in the middle.
ResultRow timed(const std::string& method, double low, double high) {
  ResultRow timed = row("one", method, 0);
  timed.seconds = {(low + high) / 2, low, high, Interval{low, high}};
  return timed;
}

TEST(UnitClaims, TimesWhoseIntervalsOverlapAreUndecided) {
  const Claim order = claim("seconds", {{"a"}, {"b"}});
  EXPECT_EQ(verdict_of(order, {timed("a", 1, 2), timed("b", 2.1, 3)}), "the same here");
  EXPECT_EQ(verdict_of(order, {timed("a", 1, 2), timed("b", 1.9, 3)}),
            "undecided: a and b are tied (1000.0–2000.0, 1900.0–3000.0)");
  // The medians are as claimed, or against it: neither is known.
  EXPECT_THAT(verdict_of(order, {timed("a", 2, 3), timed("b", 1, 2.1)}), HasSubstr("undecided"));
  EXPECT_EQ(verdict_of(order, {timed("a", 2.2, 3), timed("b", 1, 2.1)}),
            "otherwise here: b before a");
}

TEST(UnitClaims, WhatIsAgainstAClaimIsSaidBeforeWhatIsOpen) {
  const Claim order = claim("seconds", {{"a"}, {"b", "c"}});
  EXPECT_EQ(verdict_of(order, {timed("a", 2, 3), timed("b", 2, 3), timed("c", 1, 1.5)}),
            "otherwise here: c before a");
}

TEST(UnitClaims, TimesWithoutAnIntervalDecideNothing) {
  ResultRow unknown = timed("b", 5, 6);
  unknown.seconds.interval.reset();
  EXPECT_EQ(verdict_of(claim("seconds", {{"a", "c"}, {"b"}}),
                       {timed("a", 1, 2), unknown, timed("c", 1, 2)}),
            "undecided: b has no interval, as of a time that was taken less than five times");
}

/// Of the first picture, or of one stage, there is one time alone; which step took longest hangs on
/// times, too.
TEST(UnitClaims, ATimeOfWhichOnlyOneIsKeptDecidesNothing) {
  ResultRow a = timed("a", 1, 2), b = timed("b", 3, 4);
  a.first_seconds = 1, b.first_seconds = 100;
  EXPECT_THAT(verdict_of(claim("first_frame_ms", {{"a"}, {"b"}}), {a, b}), HasSubstr("undecided"));
  const auto with_steps = [&](double second_low) {
    ResultRow row = timed("a", 1, 2);
    row.steps = {{"one", {1, 1, 1, Interval{0.9, 1.1}}},
                 {"two", {1.3, 1.3, 1.3, Interval{second_low, 1.5}}}};
    row.measures.push_back({"longest_step", "", "", 2, Better::neither});
    return row;
  };
  const auto held = [&](const ResultRow& row) {
    Claim least{"", {nullptr, "longest_step", Better::higher}, {{"a"}}};
    least.bound = 2;
    return verdict_of(least, {row});
  };
  EXPECT_EQ(held(with_steps(1.2)), "the same here");
  EXPECT_THAT(held(with_steps(1.05)), HasSubstr("undecided"));
}

// b / a is between 3/2 and 4/1.
TEST(UnitClaims, AFactorHoldsForTheWholeIntervalOfTheRatio) {
  const std::vector<ResultRow> two{timed("a", 1, 2), timed("b", 3, 4)};
  Claim times = claim("seconds", {{"a"}, {"b"}});
  times.factor = 1.5;
  EXPECT_EQ(verdict_of(times, two), "the same here");
  times.factor = 1.6;
  EXPECT_EQ(verdict_of(times, two), "undecided: a before b by a factor of 1.5 to 4, around 1.6");
  times.factor = 4.1;
  EXPECT_EQ(verdict_of(times, two), "otherwise here: a before b by a factor of 2.33, not 4.1");
}

TEST(UnitClaims, ABoundWithinAnIntervalIsUndecided) {
  Claim most = claim("seconds", {{"a"}});
  const std::vector<ResultRow> one{timed("a", 1, 2)};
  most.bound = 2;
  EXPECT_EQ(verdict_of(most, one), "the same here");
  most.bound = 1.9;
  EXPECT_EQ(verdict_of(most, one), "undecided: 1000.0–2000.0 is around 1900.0");
  most.bound = 0.9;
  EXPECT_EQ(verdict_of(most, one), "otherwise here: 1500.0, not 900.0");
}

// Between 0.95 and 1.05 s every number is rounded to 1.0.
TEST(UnitClaims, APrintedTimeIsUndecidedWhereItsIntervalReachesBeyond) {
  Claim printed = claim("seconds", {{"a"}});
  printed.same = true;
  printed.bound = 1;
  printed.within = 0.05;
  EXPECT_EQ(verdict_of(printed, {timed("a", 0.96, 1.04)}), "the same here");
  EXPECT_EQ(verdict_of(printed, {timed("a", 0.94, 1.04)}),
            "undecided: 940.0–1040.0 is around 1000.0");
  EXPECT_EQ(verdict_of(printed, {timed("a", 0.96, 1.06)}),
            "undecided: 960.0–1060.0 is around 1000.0");
  EXPECT_EQ(verdict_of(printed, {timed("a", 0.5, 0.94)}), "otherwise here: 720.0, not 1000.0");
  EXPECT_EQ(verdict_of(printed, {timed("a", 1.06, 2)}), "otherwise here: 1530.0, not 1000.0");
}

TEST(UnitClaims, TimesMayBeClaimedNotToBeToldApart) {
  Claim same = claim("seconds", {{"a", "b", "c"}});
  same.same = true;
  EXPECT_EQ(verdict_of(same, {timed("a", 1, 2), timed("b", 2, 3), timed("c", 1.5, 2)}),
            "the same here");
  EXPECT_EQ(verdict_of(same, {timed("a", 1, 1.4), timed("b", 2, 3), timed("c", 1.3, 2)}),
            "otherwise here: a and b differ (1000.0–1400.0, 2000.0–3000.0)");
}

// Ratios of a and b reach from 1.05/1.1 to 1.2/1.
TEST(UnitClaims, WithAWidthTheWholeIntervalOfTheRatioHasToLieWithin) {
  const std::vector<ResultRow> two{timed("a", 1, 1.1), timed("b", 1.05, 1.2)};
  Claim same = claim("seconds", {{"a", "b"}});
  same.same = true;
  same.within = 0.21;
  EXPECT_EQ(verdict_of(same, two), "the same here");
  same.within = 0.19;
  EXPECT_THAT(verdict_of(same, two), HasSubstr("undecided: a and b may differ"));
  EXPECT_THAT(verdict_of(same, {timed("a", 1, 1.1), timed("b", 1.32, 2)}),
              HasSubstr("otherwise here: a and b differ"));
  Claim errors = claim("rmse", {{"a", "b"}});  // 0.1 and 0.2 on scene one
  errors.same = true;
  errors.within = 1;
  EXPECT_EQ(verdict_of(errors, rows), "the same here");
  errors.within = 0.9;
  EXPECT_THAT(verdict_of(errors, rows), HasSubstr("otherwise here"));
}

// On scene one it is open, on scene two otherwise: what is otherwise says nothing of the other.
TEST(UnitClaims, WhereNoneAgreesAnUndecidedSceneIsSaid) {
  std::vector<ResultRow> four{timed("a", 1, 3), timed("b", 2, 4), timed("a", 2, 4),
                              timed("b", 1, 1.5)};
  four[2].scene = four[3].scene = "two";
  Claim order = claim("seconds", {{"a"}, {"b"}});
  order.somewhere = true;
  const auto checks = check_claim(order, scenes, four);
  ASSERT_EQ(checks.size(), 1u);
  EXPECT_EQ(checks[0].of, "one");
}

// The means of the ends are 1.5 to 3 and 3.1 to 4.
TEST(UnitClaims, TheMeanOverScenesHasTheMeanOfTheEnds) {
  std::vector<ResultRow> four{timed("a", 1, 2), timed("b", 3, 4), timed("a", 2, 4),
                              timed("b", 3.2, 4)};
  four[2].scene = four[3].scene = "two";
  const auto checks = check_claim(claim("seconds", {{"a"}, {"b"}}), scenes, four);
  ASSERT_EQ(checks.size(), 3u);
  EXPECT_THAT(verdict(checks[1]), HasSubstr("undecided"));
  EXPECT_EQ(verdict(checks[2]), "the same here");
  EXPECT_DOUBLE_EQ(checks[2].values[0].interval->high, 3);
}

}  // namespace
}  // namespace pellucid::compare
