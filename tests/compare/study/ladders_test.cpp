// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/study/ladders.h"

#include <gmock/gmock.h>

#include <limits>

#include "compare/report/tables.h"
#include "compare/study/study.h"
#include "core/error.h"
#include "core/options/names.h"
#include "tests/compare/fake_methods.h"
#include "tests/compare/study/result_rows.h"
#include "tests/compare/study_folder.h"

namespace pellucid::compare {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;
using namespace pellucid::compare::testing;

Ladder ladder(const char* by, double bound) {
  const Column& column = find_row("number", by, columns());
  return {"Layers", {&column, {}, column.better}, bound, {"1", "10", "100"}};
}

std::string where_breaks(const Ladder& ladder, std::vector<ResultRow> rows) {
  return text_of(break_point(ladder, "a", rows), ladder);
}

TEST(UnitLadders, TheFirstSceneBeyondTheBoundIsNamedThoughALaterOneHolds) {
  const std::vector<ResultRow> rows{row("1", "a", 0), row("10", "a", 0.25), row("100", "a", 0)};
  EXPECT_EQ(where_breaks(ladder("rmse", 0.125), rows), "10 (2.50e-01)");
  EXPECT_EQ(where_breaks(ladder("ssim", 0.875), rows), "10 (0.7500)");
}

TEST(UnitLadders, TheBoundItselfHolds) {
  EXPECT_EQ(where_breaks(ladder("rmse", 0.25),
                         {row("1", "a", 0), row("10", "a", 0.25), row("100", "a", 0.25)}),
            "holds");
}

TEST(UnitLadders, AFailureAndNoNumberAreBreaks) {
  std::vector<ResultRow> rows{row("1", "a", 0), row("10", "a", 0), row("100", "a", 0)};
  rows[1].error = "out of memory";
  EXPECT_EQ(where_breaks(ladder("rmse", 0.1), rows), "10 (failed)");
  rows[0] = row("1", "a", std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(break_point(ladder("rmse", 0.1), "a", rows).scene, "1");
}

// What comes before a break decides; what comes after it does not matter.
TEST(UnitLadders, NothingIsSaidBeyondASceneThatIsMissing) {
  EXPECT_EQ(where_breaks(ladder("rmse", 0.1), {row("1", "a", 0), row("100", "a", 0)}), "–");
  EXPECT_EQ(where_breaks(ladder("rmse", 0.1), {row("1", "a", 0.5), row("100", "a", 0)}),
            "1 (5.00e-01)");
}

TEST(UnitLadders, TheTableHasALineForEachCallButTheReference) {
  std::vector<ResultRow> rows{row("1", "exact", 0), row("1", "a", 0.5), row("1", "b", 0),
                              row("10", "b", 0), row("100", "b", 0)};
  rows[0].reference = true;
  const LadderTable table = ladder_table(std::vector{ladder("rmse", 0.125)}, rows);
  EXPECT_THAT(table.heads, ElementsAre("Layers: RMSE above 1.25e-01"));
  ASSERT_EQ(table.lines.size(), 2u);
  EXPECT_EQ(table.lines[0].first, "a");
  EXPECT_THAT(table.lines[1].second, ElementsAre("holds"));
}

Study study_with(const std::string& ladder) {
  const StudyFolder folder;
  return load_study(folder.study(R"(["shifted:by=0.5"])", R"("ladders": [)" + ladder + "]"),
                    fake_methods());
}

TEST(UnitLadders, AreReadFromTheStudyAndPrinted) {
  const Study study =
      study_with(R"({"title": "A | b", "by": "rmse", "bound": 0.1, "scenes": ["two", "one"]})");
  ASSERT_EQ(study.ladders.size(), 1u);
  EXPECT_THAT(study.ladders[0].scenes, ElementsAre("two", "one"));
  const std::string text = markdown_table(study, std::vector{row("two", "a", 0.5)});
  EXPECT_THAT(text, HasSubstr("| Method | A \\| b: RMSE above 1.00e-01 |"));
  EXPECT_THAT(text, HasSubstr("| a | two (5.00e-01) |"));
}

TEST(UnitLadders, ScenesThatTheStudyLacksAreRefused) {
  const std::string start = R"({"title": "T", "by": "rmse", "bound": 0.1, "scenes": )";
  EXPECT_THAT([&] { study_with(start + R"(["tow"]})"); },
              ThrowsMessage<InputError>(HasSubstr("ladders[0].scenes[0]: unknown scene 'tow'")));
  EXPECT_THAT([&] { study_with(start + "[]}"); },
              ThrowsMessage<InputError>(HasSubstr("ladders[0].scenes: []")));
}

}  // namespace
}  // namespace pellucid::compare
