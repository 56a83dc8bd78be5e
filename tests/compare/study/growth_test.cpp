// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/study/growth.h"

#include <gmock/gmock.h>

#include <cmath>

#include "compare/report/tables.h"
#include "core/options/names.h"
#include "tests/compare/study_error.h"

namespace pellucid::compare {
namespace {

using ::testing::HasSubstr;
using namespace pellucid::compare::testing;

using Points = std::vector<std::pair<double, double>>;

const Column& seconds() { return find_row("column", "seconds", columns()); }

ResultRow timed_row(const char* scene, const char* method, double taken) {
  ResultRow row;
  row.scene = scene;
  row.method = method;
  row.seconds.median = taken;
  row.steps = {{"all", {taken, taken, taken}}};
  return row;
}

TEST(UnitGrowth, APowerLawHasItsExponentAndNoScatter) {
  Points points;
  for (const double x : {2.0, 8.0, 32.0, 128.0}) points.emplace_back(x, 3 * std::pow(x, 1.5));
  const PowerLaw law = power_law(points).value();
  EXPECT_NEAR(law.exponent, 1.5, 1e-14);
  EXPECT_NEAR(law.interval->low, 1.5, 1e-6);  // the root of residuals of some 1e-16
  EXPECT_NEAR(law.interval->high, 1.5, 1e-6);
  EXPECT_NEAR(law.last_exponent, 1.5, 1e-14);
}

// y = 1, e², e² at x = 1, e, e²: the slope is 1, the residuals -1/3·(1, -2, 1), s² = 2/3, and
// t(0.975; 1) = 12.7062, so that half of the interval is 12.7062 √(2/3 / 2) = 7.336.
TEST(UnitGrowth, TheIntervalIsStudentsOfTheScatter) {
  const double e = std::exp(1.0);
  const PowerLaw law = power_law(Points{{1, 1}, {e, e * e}, {e * e, e * e}}).value();
  EXPECT_NEAR(law.exponent, 1, 1e-12);
  EXPECT_NEAR(law.interval->high - law.exponent, 7.3359, 1e-4);
  EXPECT_NEAR(law.exponent - law.interval->low, 7.3359, 1e-4);
  EXPECT_NEAR(law.last_exponent, 0, 1e-12);
}

TEST(UnitGrowth, TwoPointsHaveNoIntervalAndOneNoLaw) {
  EXPECT_EQ(text_of(power_law(Points{{1, 2}, {10, 20}})), "1.00, last 1.00");
  EXPECT_EQ(text_of(power_law(Points{{1, 2}})), "–");
  EXPECT_EQ(text_of(power_law(Points{{1, 2}, {1, 3}})), "–");
}

// Methods without memory of their own need 0 bytes, which has no logarithm.
TEST(UnitGrowth, WhatHasNoLogarithmIsNoPoint) {
  EXPECT_FALSE(power_law(Points{{1, 0}, {10, 0}, {100, 0}}));
  EXPECT_NEAR(power_law(Points{{1, 0}, {10, 5}, {100, 50}})->exponent, 1, 1e-14);
  EXPECT_NEAR(power_law(Points{{1, INFINITY}, {10, 5}, {100, 50}})->exponent, 1, 1e-14);
}

TEST(UnitGrowth, EachCallHasACurveOfWhatIsKnown) {
  const Growth growth{"Points", {&seconds()}, {{"large", 100}, {"small", 10}, {"gone", 1000}}};
  std::vector<ResultRow> rows{timed_row("small", "a", 2), timed_row("small", "b", 1),
                              timed_row("large", "a", 20), timed_row("other", "a", 5),
                              timed_row("large", "b", 1)};
  rows.back().error = "lost";
  const std::vector<GrowthCurve> curves = growth_curves(growth, seconds(), rows);
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_EQ(curves[0].call, "a");
  EXPECT_EQ(curves[0].points, (Points{{10, 2}, {100, 20}}));
  EXPECT_NEAR(curves[0].law->exponent, 1, 1e-14);
  EXPECT_EQ(curves[1].points, (Points{{10, 1}}));
  EXPECT_FALSE(curves[1].law);
}

Study study_of_growth(const std::string& growth) {
  const StudyFolder folder;
  return load_study(folder.study(R"(["shifted:by=0.5"])", R"("growth": [)" + growth + "]"),
                    fake_methods());
}

TEST(UnitGrowth, IsReadFromTheStudyAndPrinted) {
  const Study study = study_of_growth(R"({"title": "Pixels", "scenes": {"one": 384, "two": 520}})");
  ASSERT_EQ(study.growth.size(), 1u);
  EXPECT_EQ(study.growth[0].by.size(), 2u);  // time and memory
  const std::vector<ResultRow> rows{timed_row("one", "a", 384e-6), timed_row("two", "a", 520e-6)};
  const std::string table = markdown_table(study, rows);
  EXPECT_THAT(table, HasSubstr("How costs grow"));
  EXPECT_THAT(table, HasSubstr("| Pixels: exponent of | Time | Memory |"));
  EXPECT_THAT(table, HasSubstr("| a | 1.00, last 1.00 | – |"));
}

TEST(UnitGrowth, WhatTellsNoGrowthIsRefused) {
  const auto error = [](const std::string& growth) {
    return study_error("[]", R"("growth": [)" + growth + "]");
  };
  EXPECT_THAT(error(R"({"title": "P", "scenes": {"one": 1, "tow": 2}})"),
              HasSubstr("growth[0].scenes.tow: unknown scene 'tow'"));
  EXPECT_THAT(error(R"({"title": "P", "scenes": {"one": 1, "two": 0}})"),
              HasSubstr("growth[0].scenes.two: 0"));
  EXPECT_THAT(error(R"({"title": "P", "scenes": {"one": 1}})"),
              HasSubstr("two of the study's scenes or more"));
  EXPECT_THAT(error(R"({"title": "P", "by": [], "scenes": {"one": 1, "two": 2}})"),
              HasSubstr("growth[0].by: []"));
  EXPECT_THAT(error(R"({"title": "P", "by": ["secnds"], "scenes": {"one": 1, "two": 2}})"),
              HasSubstr("growth[0].by[0]: unknown column 'secnds'"));
}

}  // namespace
}  // namespace pellucid::compare
