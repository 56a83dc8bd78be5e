// SPDX-License-Identifier: GPL-3.0-or-later
// Claims as a study file has them: what is read, and what is refused.
#include <gmock/gmock.h>

#include "compare/study/study.h"
#include "tests/compare/fake_methods.h"
#include "tests/compare/study_error.h"
#include "tests/compare/study_folder.h"

namespace pellucid::compare {
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using namespace pellucid::compare::testing;

std::string claims_error(const std::string& claims) {
  return study_error(R"(["shifted:by=0.5", "broken"])", R"("claims": [)" + claims + "]");
}

Claim read_first(const std::string& methods, const std::string& claim) {
  const StudyFolder folder;
  return load_study(folder.study(methods, R"("claims": [)" + claim + "]"), fake_methods())
      .claims.front();
}

TEST(UnitReadClaims, ABoundMayBeOfAllCalls) {
  EXPECT_THAT(read_first(R"(["shifted:by=0.5", "broken"])",
                         R"({"claim": "x", "by": "rmse", "of": "*", "at_most": 1})")
                  .order,
              ElementsAre(ElementsAre("shifted:by=0.5", "broken")));
  EXPECT_THAT(
      study_error("[]", R"("claims": [{"claim": "x", "by": "rmse", "of": "*", "at_most": 1}])"),
      HasSubstr("claims[0].of: \"*\", and no methods"));
}

TEST(UnitReadClaims, AStudyNamesAStage) {
  const Claim read = read_first(R"(["broken"])", R"({"claim": "x", "stage": "mesh", "of": "broken",
                                                     "better": "higher", "at_least": 0.5})");
  EXPECT_EQ(read.by.stage, "mesh");
  EXPECT_EQ(read.by.better, Better::higher);
  EXPECT_THAT(claims_error(R"({"claim": "x", "stage": "mesh", "measure": "m", "of": "broken",
                               "at_most": 1})"),
              HasSubstr("claims[0].stage: beside 'measure'"));
  EXPECT_THAT(claims_error(R"({"claim": "x", "stage": "mash", "of": "broken", "at_most": 1})"),
              AllOf(HasSubstr("claims[0].stage"), HasSubstr("mash"), HasSubstr("mesh")));
}

TEST(UnitReadClaims, AStudySaysThatOneHoldsSomewhere) {
  const std::string start = R"({"claim": "x", "by": "rmse", "of": "broken", )";
  EXPECT_FALSE(read_first(R"(["broken"])", start + R"("at_most": 1})").somewhere);
  EXPECT_TRUE(read_first(R"(["broken"])", start + R"("at_most": 1, "somewhere": true})").somewhere);
  EXPECT_THAT(claims_error(start + R"("scene_order": ["one", "two"], "somewhere": true})"),
              HasSubstr("claims[0].somewhere"));
}

TEST(UnitReadClaims, MonotonyIsAnOrderByAParameter) {
  const char* sweep = R"([{"method": "shifted", "by": [0.25, 0.75, 0.5]}, "broken"])";
  EXPECT_THAT(read_first(sweep, R"({"claim": "x", "by": "rmse", "of": "shifted",
                                    "worsens_with": "by"})")
                  .order,
              ElementsAre(ElementsAre("shifted:by=0.25"), ElementsAre("shifted:by=0.5"),
                          ElementsAre("shifted:by=0.75")));
  EXPECT_THAT(read_first(sweep, R"({"claim": "x", "by": "rmse", "improves_with": "by",
                                    "of": ["shifted:by=0.25", "shifted:by=0.5"]})")
                  .order,
              ElementsAre(ElementsAre("shifted:by=0.5"), ElementsAre("shifted:by=0.25")));
}

TEST(UnitReadClaims, MonotonyNeedsANumberInWhichCallsDiffer) {
  const std::string start = R"({"claim": "x", "by": "rmse", "of": )";
  EXPECT_THAT(claims_error(start + R"(["shifted:by=0.5", "broken"], "improves_with": "by"})"),
              HasSubstr("claims[0].improves_with: 'by': 'broken' has no such number"));
  EXPECT_THAT(claims_error(start + R"("shifted:by=0.5", "improves_with": "how"})"),
              HasSubstr("'how': 'shifted:by=0.5' has no such number"));
  EXPECT_THAT(claims_error(start + R"("shifted:by=0.5", "improves_with": "by"})"),
              HasSubstr("claims[0].of: shifted:by=0.5: one call has no order; accepted: at least"));
  EXPECT_THAT(claims_error(start + R"("shifted", "improves_with": "by"})"),
              HasSubstr("claims[0].of: shifted:by=0.5: one call has no order"));
  EXPECT_THAT(claims_error(start + R"("broken", "improves_with": "by", "worsens_with": "by"})"),
              HasSubstr("accepted: one of the two"));
}

TEST(UnitReadClaims, ASameNumberIsATimeOrHasAWidth) {
  const std::string calls = R"("same": ["broken", "truth"])";
  EXPECT_EQ(claims_error(R"({"claim": "x", "by": "seconds", )" + calls + "}"), "no error");
  EXPECT_EQ(claims_error(R"({"claim": "x", "by": "rmse", "within": 0.1, )" + calls + "}"),
            "no error");
  EXPECT_THAT(claims_error(R"({"claim": "x", "by": "rmse", )" + calls + "}"),
              HasSubstr("claims[0].same: 'RMSE' has no interval; accepted: beside 'within'"));
  EXPECT_THAT(claims_error(R"({"claim": "x", "by": "seconds", "same": ["broken"]})"),
              HasSubstr("at least two calls"));
}

TEST(UnitReadClaims, APrintedNumberHasTheWidthOfItsLastDigit) {
  const std::string number = R"("claim": "x", "by": "ssim", "of": "broken", "equals": 0.959)";
  const Claim read = read_first(R"(["broken"])", "{" + number + R"(, "within": 0.0005})");
  EXPECT_TRUE(read.same);
  EXPECT_EQ(read.bound, 0.959);
  EXPECT_EQ(read.within, 0.0005);
  EXPECT_THAT(claims_error("{" + number + "}"), HasSubstr("within"));
  EXPECT_THAT(claims_error("{" + number + R"(, "within": 0.0005, "at_least": 0.9})"),
              HasSubstr("claims[0].at_least: beside 'equals'"));
  EXPECT_THAT(claims_error("{" + number + R"(, "within": 0.0005, "order": ["broken", "truth"]})"),
              HasSubstr("claims[0].order: beside 'equals'"));
}

TEST(UnitReadClaims, AStudyNamesCallsThatItHas) {
  EXPECT_EQ(claims_error(R"({"claim": "x", "by": "rmse", "order": ["truth", ["broken"]]})"),
            "no error");
  EXPECT_THAT(claims_error(R"({"claim": "x", "by": "rmse", "order": ["truth", "shifted"]})"),
              AllOf(HasSubstr("claims[0].order[1]: unknown call 'shifted'"),
                    HasSubstr("known: truth, broken, shifted:by=0.5")));
  EXPECT_THAT(claims_error(R"({"claim": "x", "by": "fragments", "order": ["truth", "broken"]})"),
              HasSubstr("claims[0].by: 'fragments': no way is better"));
  EXPECT_THAT(claims_error(R"({"claim": "x", "by": "rsme", "order": ["truth", "broken"]})"),
              HasSubstr("unknown number 'rsme'; known: rmse"));
  EXPECT_THAT(claims_error(R"({"claim": "x", "by": "rmse", "order": ["truth"]})"),
              HasSubstr("at least two calls"));
}

/// A call held against itself says nothing, and a scene would count twice in the mean.
TEST(UnitReadClaims, EachIsNamedOnce) {
  const std::string start = R"({"claim": "x", "by": "seconds", )";
  for (const auto& [rest, place] :
       {std::pair(R"("order": ["broken", "broken"]})", "order[1]: a second 'broken'"),
        {R"("order": [["truth", "broken"], "broken"]})", "order[1]: a second 'broken'"},
        {R"("order": [["broken", "broken"], "truth"]})", "order[0][1]: a second 'broken'"},
        {R"("same": ["broken", "broken"]})", "same[1]: a second 'broken'"},
        {R"("of": "broken", "at_most": 1, "scenes": ["one", "two", "one"]})",
         "scenes[2]: a second 'one'"},
        {R"("of": "broken", "scene_order": ["one", "one"]})", "scene_order[1]: a second 'one'"},
        {R"("of": "broken", "at_most": 1, "scenes": []})", "scenes: []; accepted: names"}})
    EXPECT_THAT(claims_error(start + rest), HasSubstr(std::string("claims[0].") + place)) << rest;
  const char* cost = R"({"scene": "one", "method": "truth", "ms": 1})";
  EXPECT_THAT(study_error("[]", std::string(R"("published": {"machine": "m", "rows": [)") + cost +
                                    ", " + cost + "]}"),
              HasSubstr("published.rows[1]: a second cost of 'truth' on 'one'"));
  EXPECT_THAT(study_error("[]", R"("measures": ["hull", "hull"])"),
              HasSubstr("measures[1]: a second 'hull'"));
}

/// The place of what is no text stands once before it.
TEST(UnitReadClaims, APlaceIsNamedOnce) {
  EXPECT_THAT(claims_error(R"({"claim": "x", "by": 3, "order": ["truth", "broken"]})"),
              Not(ContainsRegex("by: .*by: ")));
  for (const char* more : {R"("measures": [3])", R"("opacities": 3)", R"("opacities": "nothing")"})
    EXPECT_THAT(study_error("[]", more), Not(ContainsRegex("study.json.*study.json"))) << more;
}

TEST(UnitReadClaims, ABoundIsOnTheWorseSide) {
  EXPECT_EQ(claims_error(R"({"claim": "x", "by": "rmse", "of": ["broken"], "at_most": 0.1})"),
            "no error");
  EXPECT_THAT(
      claims_error(R"({"claim": "x", "by": "rmse", "of": ["broken"], "at_least": 0.1})"),
      HasSubstr("claims[0].at_least: 'RMSE' is better when it is lower; accepted: at_most"));
  EXPECT_THAT(claims_error(R"({"claim": "x", "measure": "m", "better": "higher", "of": ["broken"],
                           "at_most": 1})"),
              HasSubstr("accepted: at_least"));
  EXPECT_THAT(
      claims_error(R"({"claim": "x", "by": "rmse", "of": ["broken"], "scene_order": ["s"]})"),
      HasSubstr("claims[0].scene_order[0]: unknown scene 's'"));
}

TEST(UnitReadClaims, KeysThatWouldSayNothingAreRefused) {
  const std::string start = R"({"claim": "x", "by": "rmse", )";
  for (const auto& [rest, key] :
       {std::pair(R"("order": ["truth", "broken"], "of": "broken"})", "of"),
        {R"("order": ["truth", "broken"], "at_most": 1})", "at_most"},
        {R"("of": "broken", "at_most": 1, "factor": 2})", "factor"},
        {R"("of": "broken", "scene_order": ["one", "two"], "at_most": 1})", "at_most"},
        {R"("of": "broken", "at_most": 1, "measure": "m"})", "measure"}})
    EXPECT_THAT(claims_error(start + rest), AllOf(HasSubstr(std::string("claims[0].") + key),
                                                  HasSubstr("accepted: one of the two")))
        << rest;
  EXPECT_THAT(claims_error(start + R"("of": [], "at_most": 1})"), HasSubstr("at least one call"));
}

}  // namespace
}  // namespace pellucid::compare
