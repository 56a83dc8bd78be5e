// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/study/claims.h"

#include <gmock/gmock.h>

#include "compare/report/tables.h"
#include "compare/study/study.h"
#include "core/error.h"
#include "core/options/names.h"
#include "tests/compare/fake_methods.h"
#include "tests/compare/study_folder.h"

namespace pellucid::compare {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using namespace pellucid::compare::testing;

ResultRow row(const std::string& scene, const std::string& method, double rmse) {
  ResultRow row;
  row.scene = scene;
  row.method = method;
  row.metrics.linear.of("rmse") = rmse;
  row.metrics.linear.of("ssim") = 1 - rmse;
  return row;
}

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
  EXPECT_DOUBLE_EQ(checks[2].values[1].second, 0.225);
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

TEST(UnitClaims, AClaimMayBeAboutSomeScenes) {
  Claim one = claim("rmse", {{"a"}, {"b"}});
  one.scenes = {"two"};
  const auto checks = check_claim(one, scenes, rows);
  ASSERT_EQ(checks.size(), 1u);
  EXPECT_EQ(checks[0].of, "two");
}

TEST(UnitClaims, ScenesMayBeInOrderForEachCall) {
  Claim order = claim("rmse", {{"a", "b"}});
  order.scenes = {"two", "one"};
  order.orders_scenes = true;
  const auto checks = check_claim(order, scenes, rows);
  ASSERT_EQ(checks.size(), 2u);
  EXPECT_EQ(checks[0].of, "a");
  EXPECT_EQ(checks[0].values[1], (std::pair<std::string, double>("one", 0.1)));
  EXPECT_THAT(checks[0].against, ElementsAre("one before two"));
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

TEST(UnitClaims, ASceneThatLacksARowIsLeftOut) {
  std::vector<ResultRow> fewer = rows;
  fewer[1].error = "failed";
  const auto checks = check_claim(claim("rmse", {{"a"}, {"b"}}), scenes, fewer);
  ASSERT_EQ(checks.size(), 1u);
  EXPECT_EQ(checks[0].of, "two");
}

std::string error_of(const std::string& claims) {
  const StudyFolder folder;
  try {
    load_study(folder.study(R"(["shifted:by=0.5", "broken"])", R"("claims": [)" + claims + "]"),
               fake_methods());
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(UnitClaims, AStudyNamesCallsThatItHas) {
  EXPECT_EQ(error_of(R"({"claim": "x", "by": "rmse", "order": ["truth", ["broken"]]})"),
            "no error");
  EXPECT_THAT(error_of(R"({"claim": "x", "by": "rmse", "order": ["truth", "shifted"]})"),
              AllOf(HasSubstr("claims[0].order[1]: unknown call 'shifted'"),
                    HasSubstr("known: truth, broken, shifted:by=0.5")));
  EXPECT_THAT(error_of(R"({"claim": "x", "by": "fragments", "order": ["truth", "broken"]})"),
              HasSubstr("claims[0].by: 'fragments': no way is better"));
  EXPECT_THAT(error_of(R"({"claim": "x", "by": "rsme", "order": ["truth", "broken"]})"),
              HasSubstr("unknown number 'rsme'; known: rmse"));
  EXPECT_THAT(error_of(R"({"claim": "x", "by": "rmse", "order": ["truth"]})"),
              HasSubstr("at least two calls"));
}

TEST(UnitClaims, ABoundIsOnTheWorseSide) {
  EXPECT_EQ(error_of(R"({"claim": "x", "by": "rmse", "of": ["broken"], "at_most": 0.1})"),
            "no error");
  EXPECT_THAT(
      error_of(R"({"claim": "x", "by": "rmse", "of": ["broken"], "at_least": 0.1})"),
      HasSubstr("claims[0].at_least: 'RMSE' is better when it is lower; accepted: at_most"));
  EXPECT_THAT(error_of(R"({"claim": "x", "measure": "m", "better": "higher", "of": ["broken"],
                           "at_most": 1})"),
              HasSubstr("accepted: at_least"));
  EXPECT_THAT(error_of(R"({"claim": "x", "by": "rmse", "of": ["broken"], "scene_order": ["s"]})"),
              HasSubstr("claims[0].scene_order[0]: unknown scene 's'"));
}

TEST(UnitClaims, KeysThatWouldSayNothingAreRefused) {
  const std::string start = R"({"claim": "x", "by": "rmse", )";
  for (const auto& [rest, key] :
       {std::pair(R"("order": ["truth", "broken"], "of": "broken"})", "of"),
        {R"("order": ["truth", "broken"], "at_most": 1})", "at_most"},
        {R"("of": "broken", "at_most": 1, "factor": 2})", "factor"},
        {R"("of": "broken", "scene_order": ["one", "two"], "at_most": 1})", "at_most"},
        {R"("of": "broken", "at_most": 1, "measure": "m"})", "measure"}})
    EXPECT_THAT(error_of(start + rest), AllOf(HasSubstr(std::string("claims[0].") + key),
                                              HasSubstr("accepted: one of the two")))
        << rest;
  EXPECT_THAT(error_of(start + R"("of": [], "at_most": 1})"), HasSubstr("at least one call"));
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
                    HasSubstr("- two: a 4.00e-01, b 2.50e-01; otherwise here: b before a;\n")));
}

}  // namespace
}  // namespace pellucid::compare
