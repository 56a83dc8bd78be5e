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
using ::testing::Pair;
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
  return {"", &find_row("number", by, columns()), std::move(order)};
}

TEST(UnitClaims, TheBetterOneIsSmallerInErrorAndLargerInSimilarity) {
  for (const char* by : {"rmse", "ssim"}) {
    const auto checks = check_claim(claim(by, {{"a"}, {"b"}, {"c"}}), scenes, rows);
    ASSERT_EQ(checks.size(), 3u);
    EXPECT_THAT(checks[0].against, IsEmpty());
    EXPECT_THAT(checks[1].against, ElementsAre(Pair("a", "b")));
  }
}

// The means are 0.25, 0.225 and 0.4.
TEST(UnitClaims, TheMeanOverScenesIsCheckedLast) {
  const auto checks = check_claim(claim("rmse", {{"a"}, {"b"}, {"c"}}), scenes, rows);
  EXPECT_EQ(checks[2].scene, "mean");
  EXPECT_DOUBLE_EQ(checks[2].values[1].second, 0.225);
  EXPECT_THAT(checks[2].against, ElementsAre(Pair("a", "b")));
}

TEST(UnitClaims, WithinAGroupNoOrderIsClaimed) {
  const auto together = check_claim(claim("rmse", {{"c", "b", "a"}}), scenes, rows);
  EXPECT_THAT(together[0].against, IsEmpty());
  const auto groups = check_claim(claim("rmse", {{"c"}, {"a", "b"}}), scenes, rows);
  EXPECT_THAT(groups[0].against, ElementsAre(Pair("c", "a"), Pair("c", "b")));
}

TEST(UnitClaims, ASceneThatLacksARowIsLeftOut) {
  std::vector<ResultRow> fewer = rows;
  fewer[1].error = "failed";
  const auto checks = check_claim(claim("rmse", {{"a"}, {"b"}}), scenes, fewer);
  ASSERT_EQ(checks.size(), 1u);
  EXPECT_EQ(checks[0].scene, "two");
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
