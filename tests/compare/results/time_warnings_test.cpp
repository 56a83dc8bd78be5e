// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/results/time_warnings.h"

#include <gmock/gmock.h>

namespace pellucid::compare {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// A row beside which the loop took so many milliseconds, at seconds that follow one another.
ResultRow row(const std::string& method, double at, std::vector<double> loops) {
  ResultRow row;
  row.scene = "s";
  row.method = method;
  for (const double ms : loops) row.calibrations.push_back({at++, ms / 1e3});
  return row;
}

TEST(UnitTimeWarnings, AQuietMachineNeedsNone) {
  EXPECT_THAT(time_warnings({}), IsEmpty());
  EXPECT_THAT(time_warnings(std::vector{row("a", 0, {2, 2.1}), row("b", 2, {2.39, 2})}), IsEmpty());
}

// The threshold is a fifth over the best loop.
TEST(UnitTimeWarnings, ALoopThatTookAFifthLongerDisturbsItsRow) {
  const std::vector rows{row("a", 0, {2, 2}), row("b", 2, {2, 2.41}), row("c", 4, {2, 2})};
  EXPECT_THAT(time_warnings(rows),
              ElementsAre(AllOf(HasSubstr("disturbed"), HasSubstr("2.0 ms at its best"),
                                HasSubstr("up to 2.4 ms beside 1 of 3 rows (s/b)"))));
}

TEST(UnitTimeWarnings, OfManyRowsThreeAreNamed) {
  std::vector<ResultRow> rows{row("quiet", 0, {2, 2, 2})};
  for (const char* name : {"a", "b", "c", "d", "e"})
    rows.push_back(row(name, double(10 * rows.size()), {3}));
  EXPECT_THAT(time_warnings(rows).front(), HasSubstr("(s/a, s/b, s/c and 2 more)"));
}

// One stray loop that is too short does not disturb all others.
TEST(UnitTimeWarnings, TheBestIsNotTheLeastOfMany) {
  std::vector<double> loops(20, 2.0);
  loops[7] = 1.5;
  EXPECT_THAT(time_warnings(std::vector{row("a", 0, loops)}), IsEmpty());
}

TEST(UnitTimeWarnings, DriftIsOfTheClockAndNotOfTheRowsOrder) {
  const ResultRow early = row("a", 0, {2, 2, 2}), late = row("b", 10, {2.3, 2.3, 2.3});
  for (const auto& rows : {std::vector{early, late}, std::vector{late, early}})
    EXPECT_THAT(time_warnings(rows),
                ElementsAre(HasSubstr("15 % longer at the end than at the start")));
  const ResultRow faster = row("b", 10, {1.7, 1.7, 1.7});
  EXPECT_THAT(time_warnings(std::vector{early, faster}), ElementsAre(HasSubstr("15 % shorter")));
  const ResultRow little = row("b", 10, {2.19, 2.19, 2.19});
  EXPECT_THAT(time_warnings(std::vector{early, little}), IsEmpty());
}

// Rows that were measured in turn share their loops, which count once.
TEST(UnitTimeWarnings, SharedLoopsCountOnce) {
  const ResultRow a = row("a", 0, {2, 2, 2.3}), b = row("b", 0, {2, 2, 2.3});
  EXPECT_THAT(time_warnings(std::vector{a, b}), Not(::testing::Contains(HasSubstr("drifted"))));
}

TEST(UnitTimeWarnings, AnIntervalThatStayedWideIsNamed) {
  ResultRow open = row("a", 0, {2}), narrow = row("b", 1, {2}), failed = row("c", 2, {2});
  open.settled = failed.settled = false;
  narrow.settled = true;
  failed.error = "lost";
  EXPECT_THAT(
      time_warnings(std::vector{open, narrow, failed}),
      ElementsAre(AllOf(HasSubstr("1 of 3 rows reached the most repeats"), HasSubstr(": s/a."))));
}

}  // namespace
}  // namespace pellucid::compare
