// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/study/claims.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "compare/report/tables.h"
#include "tests/compare/study/checked_claims.h"

namespace pellucid::compare {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

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

TEST(UnitClaims, EqualNumbersAreOnceAsGoodAlsoOfZeroAndInfinity) {
  Claim errors = claim("rmse", {{"a"}, {"b"}});
  errors.factor = 1.5;
  EXPECT_EQ(verdict_of(errors, {row("one", "a", 0), row("one", "b", 0)}),
            "otherwise here: a before b by a factor of 1, not 1.5");
  EXPECT_EQ(verdict_of(errors, {row("one", "a", 0), row("one", "b", 0.1)}), "the same here");
  std::vector<ResultRow> exact{row("one", "a", 0), row("one", "b", 0)};
  for (ResultRow& row : exact)
    row.metrics.linear.of("psnr") = std::numeric_limits<double>::infinity();
  Claim psnr = claim("psnr", {{"a"}, {"b"}});
  psnr.factor = 1.5;
  EXPECT_EQ(verdict_of(psnr, exact), "otherwise here: a before b by a factor of 1, not 1.5");
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
  measured[0].budget->interaction = 0.625;  // what is no stage's
  share.by.stage = "interaction";
  EXPECT_THAT(check_claim(share, scenes, measured)[0].against, ElementsAre("0.625, not 0.5"));
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
