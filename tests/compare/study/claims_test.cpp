// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/study/claims.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "compare/report/tables.h"
#include "compare/study/study.h"
#include "core/options/names.h"
#include "tests/compare/study/result_rows.h"

namespace pellucid::compare {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::vector<std::string> scenes{"one", "two"};
const std::vector<ResultRow> rows{row("one", "a", 0.1),  row("one", "b", 0.2),
                                  row("one", "c", 0.3),  row("two", "a", 0.4),
                                  row("two", "b", 0.25), row("two", "c", 0.5)};

Claim claim(const char* by, std::vector<std::vector<std::string>> order) {
  const Column& column = find_row("number", by, columns());
  return {"", {&column, {}, column.better}, std::move(order)};
}

TEST(UnitClaims, TheBetterOneIsSmallerInErrorAndLargerInSimilarity) {
  for (const char* by : {"rmse", "ssim"}) {
    const auto checks = check_claim(claim(by, {{"a"}, {"b"}, {"c"}}), scenes, rows);
    ASSERT_EQ(checks.size(), 3u);
    EXPECT_THAT(checks[0].against, IsEmpty());
    EXPECT_THAT(checks[1].against, ElementsAre("b before a"));
  }
}

// The means are 0.25, 0.225 and 0.4.
TEST(UnitClaims, TheMeanOverScenesIsCheckedLast) {
  const auto checks = check_claim(claim("rmse", {{"a"}, {"b"}, {"c"}}), scenes, rows);
  EXPECT_EQ(checks[2].of, "mean");
  EXPECT_DOUBLE_EQ(checks[2].values[1].value, 0.225);
  EXPECT_THAT(checks[2].against, ElementsAre("b before a"));
}

TEST(UnitClaims, WithinAGroupNoOrderIsClaimed) {
  const auto together = check_claim(claim("rmse", {{"c", "b", "a"}}), scenes, rows);
  EXPECT_THAT(together[0].against, IsEmpty());
  const auto groups = check_claim(claim("rmse", {{"c"}, {"a", "b"}}), scenes, rows);
  EXPECT_THAT(groups[0].against, ElementsAre("a before c", "b before c"));
}

// Of c / a and c / b on scene one a factor of 3 and of 1.5.
TEST(UnitClaims, AFactorIsPartOfTheOrder) {
  Claim two = claim("rmse", {{"a", "b"}, {"c"}});
  two.factor = 2;
  EXPECT_THAT(check_claim(two, scenes, rows)[0].against,
              ElementsAre("b before c by a factor of 1.5, not 2"));
  two.by = claim("ssim", {}).by;  // 0.9 and 0.8 against 0.7
  EXPECT_EQ(check_claim(two, scenes, rows)[0].against.size(), 2u);
  two.factor = 1.2;
  EXPECT_THAT(check_claim(two, scenes, rows)[0].against,
              ElementsAre("b before c by a factor of 1.14, not 1.2"));
}

TEST(UnitClaims, ABoundHoldsForEveryCall) {
  Claim most = claim("rmse", {{"a", "b"}});
  most.bound = 0.2;
  EXPECT_THAT(check_claim(most, scenes, rows)[0].against, IsEmpty());  // the bound itself holds
  EXPECT_THAT(check_claim(most, scenes, rows)[1].against,
              ElementsAre("a 4.00e-01, not 2.00e-01", "b 2.50e-01, not 2.00e-01"));
  most.order = {{"a"}};
  most.bound = 0.39999;
  EXPECT_THAT(check_claim(most, scenes, rows)[1].against, ElementsAre("0.4, not 0.39999"));
  Claim least = claim("ssim", {{"a"}});
  least.bound = 0.7;
  EXPECT_THAT(check_claim(least, scenes, rows)[0].against, IsEmpty());
  EXPECT_EQ(check_claim(least, scenes, rows)[1].against.size(), 1u);
}

// The RMSE of a is 0.1 on scene one and 0.4 on two; of b 0.2 and 0.25.
TEST(UnitClaims, APrintedNumberIsMissedOnEitherSide) {
  Claim printed = claim("rmse", {{"a"}});
  printed.same = true;
  printed.bound = 0.1004;
  printed.within = 0.0005;
  EXPECT_EQ(verdict(check_claim(printed, scenes, rows)[0]), "the same here");
  EXPECT_EQ(verdict(check_claim(printed, scenes, rows)[1]),
            "otherwise here: 4.00e-01, not 1.00e-01");
  printed.bound = 0.0994;
  EXPECT_EQ(verdict(check_claim(printed, scenes, rows)[0]),
            "otherwise here: 1.00e-01, not 9.94e-02");
  printed.bound = 0.41;
  EXPECT_EQ(verdict(check_claim(printed, scenes, rows)[1]),
            "otherwise here: 4.00e-01, not 4.10e-01");
  printed.order = {{"a", "b"}};
  printed.bound = 0.1;
  EXPECT_THAT(check_claim(printed, scenes, rows)[0].against,
              ElementsAre("b 2.00e-01, not 1.00e-01"));
}

TEST(UnitClaims, AClaimMayBeAboutSomeScenes) {
  Claim one = claim("rmse", {{"a"}, {"b"}});
  one.scenes = {"two"};
  const auto checks = check_claim(one, scenes, rows);
  ASSERT_EQ(checks.size(), 1u);
  EXPECT_EQ(checks[0].of, "two");
}

// a before b on scene one alone, c before a nowhere.
TEST(UnitClaims, AClaimMayHoldSomewhere) {
  Claim one = claim("rmse", {{"a"}, {"b"}});
  one.somewhere = true;
  const auto agreeing = check_claim(one, scenes, rows);
  ASSERT_EQ(agreeing.size(), 1u);
  EXPECT_EQ(agreeing[0].of, "one");
  EXPECT_EQ(verdict(agreeing[0]), "the same here");
  Claim none = claim("rmse", {{"c"}, {"a"}});
  none.somewhere = true;
  EXPECT_EQ(check_claim(none, scenes, rows).size(), 2u);
}

TEST(UnitClaims, ScenesMayBeInOrderForEachCall) {
  Claim order = claim("rmse", {{"a", "b"}});
  order.scenes = {"two", "one"};
  order.orders_scenes = true;
  const auto checks = check_claim(order, scenes, rows);
  ASSERT_EQ(checks.size(), 2u);
  EXPECT_EQ(checks[0].of, "a");
  EXPECT_EQ(checks[0].values[1].of, "one");
  EXPECT_EQ(checks[0].values[1].value, 0.1);
  EXPECT_THAT(checks[0].against, ElementsAre("one before two"));
}

/// A row whose time is in this interval, its median in the middle.
ResultRow timed(const std::string& method, double low, double high) {
  ResultRow timed = row("one", method, 0);
  timed.seconds = {(low + high) / 2, low, high, Interval{low, high}};
  return timed;
}

/// How a claim about times stands on scene one.
std::string verdict_of(const Claim& claim, const std::vector<ResultRow>& measured) {
  const auto checks = check_claim(claim, std::vector<std::string>{"one"}, measured);
  return checks.size() == 1 ? verdict(checks[0]) : "no check";
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

TEST(UnitClaims, WhatDoesNotChangeGetsNoBetter) {
  Claim better = claim("rmse", {{"a"}, {"b"}, {"c"}});
  better.monotone = true;
  const auto of = [&](double a, double b, double c) {
    return verdict_of(better, {row("one", "a", a), row("one", "b", b), row("one", "c", c)});
  };
  EXPECT_EQ(of(0.1, 0.2, 0.3), "the same here");
  EXPECT_EQ(of(0.1, 0.1, 0.3), "the same here");  // some may be equal
  EXPECT_EQ(of(0.1, 0.1, 0.1), "otherwise here: it does not change");
  EXPECT_EQ(of(0.2, 0.1, 0.3), "otherwise here: b before a");
}

/// As a stage's share may be, or SSIM.
TEST(UnitClaims, NumbersBelowZeroHaveNoFactorButMayBeTheSame) {
  Claim same = claim("rmse", {{"a", "b"}});
  same.same = true;
  same.within = 0.1;
  const auto of = [&](double a, double b) {
    return verdict_of(same, {row("one", "a", a), row("one", "b", b)});
  };
  EXPECT_EQ(of(-0.5, -0.5), "the same here");
  EXPECT_EQ(of(-0.5, -0.52), "the same here");
  EXPECT_THAT(of(-0.5, -0.6), HasSubstr("otherwise here: a and b differ"));
  EXPECT_THAT(of(-0.5, 0.5), HasSubstr("otherwise here: a and b differ"));
  Claim factor = claim("rmse", {{"a"}, {"b"}});
  factor.factor = 2;
  EXPECT_THAT(verdict_of(factor, {row("one", "a", -0.1), row("one", "b", 0.5)}),
              HasSubstr("undecided: a and b are not both above 0"));
}

TEST(UnitClaims, AnInfiniteNumberDoesNotHideTheOthersInTheMean) {
  std::vector<ResultRow> psnr{row("one", "a", 0), row("two", "a", 0.1)};
  psnr[0].metrics.linear.of("psnr") = std::numeric_limits<double>::infinity();
  psnr[1].metrics.linear.of("psnr") = 20;
  const auto checks = check_claim(claim("psnr", {{"a"}}), scenes, psnr);
  EXPECT_EQ(checks.back().of, "mean");
  EXPECT_EQ(checks.back().values[0].value, 20);
  psnr[1].metrics.linear.of("psnr") = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(std::isinf(check_claim(claim("psnr", {{"a"}}), scenes, psnr).back().values[0].value));
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

TEST(UnitClaims, AMeasureIsClaimedByItsName) {
  std::vector<ResultRow> measured = rows;
  measured[0].measures.push_back({"holes", "Holes", "", 3, Better::lower});
  Claim holes = claim("rmse", {{"a"}});
  holes.by = {nullptr, "holes", Better::lower};
  holes.bound = 2;
  const auto checks = check_claim(holes, scenes, measured);
  ASSERT_EQ(checks.size(), 1u);
  EXPECT_THAT(checks[0].against, ElementsAre("3, not 2"));
}

TEST(UnitClaims, AStagesShareIsClaimedByItsName) {
  std::vector<ResultRow> measured = rows;
  measured[0].budget.emplace();
  measured[0].budget->lines = {{.stage = "mesh", .refinement = "", .why_not = "", .share = 0.75},
                               {.stage = "field", .refinement = "", .why_not = "none"}};
  Claim share = claim("rmse", {{"a"}});
  share.by = {nullptr, "", Better::lower, "mesh"};
  share.bound = 0.5;
  ASSERT_EQ(check_claim(share, scenes, measured).size(), 1u);
  EXPECT_THAT(check_claim(share, scenes, measured)[0].against, ElementsAre("0.75, not 0.5"));
  EXPECT_EQ(share.by.heading(), "share of 'mesh'");
  share.by.stage = "field";  // does not apply
  EXPECT_TRUE(check_claim(share, scenes, measured).empty());
}

TEST(UnitClaims, ASceneThatLacksARowIsLeftOut) {
  std::vector<ResultRow> fewer = rows;
  fewer[1].error = "failed";
  const auto checks = check_claim(claim("rmse", {{"a"}, {"b"}}), scenes, fewer);
  ASSERT_EQ(checks.size(), 1u);
  EXPECT_EQ(checks[0].of, "two");
}

TEST(UnitClaims, WhatNoRowSaysIsSaid) {
  Study study;
  study.scenes = {"one.json"};
  study.claims = {claim("rmse", {{"a"}, {"z"}})};
  EXPECT_THAT(markdown_table(study, rows), HasSubstr("- no scene has all of its numbers\n"));
}

TEST(UnitClaims, TheTableForPeopleSaysWhatIsOtherwise) {
  Study study;
  study.scenes = {"one.json", "two.json"};
  study.claims = {claim("rmse", {{"a"}, {"b"}})};
  EXPECT_THAT(markdown_table(study, rows),
              AllOf(HasSubstr("- one: a 1.00e-01, b 2.00e-01; the same here\n"),
                    HasSubstr("- two: a 4.00e-01, b 2.50e-01; otherwise here: b before a\n")));
}

}  // namespace
}  // namespace pellucid::compare
