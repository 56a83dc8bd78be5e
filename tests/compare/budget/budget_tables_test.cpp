// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/report/budget_tables.h"

#include <gmock/gmock.h>

#include <array>
#include <cmath>

namespace pellucid::compare {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::array<ResultRow, 1> row_with_budget(const std::string& scene) {
  BudgetLine mesh, field;
  mesh.stage = "mesh";
  mesh.refinement = "a, b";
  mesh.share = 0.75;
  field.stage = "field";
  field.why_not = "=none";
  std::array<ResultRow, 1> rows;
  rows[0].scene = scene;
  rows[0].method = "fourier";
  rows[0].parameters = "bands=5,at=mid";
  rows[0].budget = {.rmse = 0.5, .seconds = 2, .interaction = 0.25, .lines = {mesh, field}};
  return rows;
}

TEST(UnitBudgetTables, ALineEachOfStagesInteractionAndWhole) {
  const std::string csv = csv_budgets(row_with_budget("abc"));
  EXPECT_THAT(csv, HasSubstr("abc,fourier,\"bands=5,at=mid\",mesh,\"a, b\",0.75,0,0,0,0,0,,\n"));
  EXPECT_THAT(csv, HasSubstr("interaction,,0.25,,,,,,,\n"));
  EXPECT_THAT(csv, HasSubstr("whole,,1,,,0.5,,2,,\n"));
}

TEST(UnitBudgetTables, AGainHasAPriceWhereTimesAreToldApart) {
  std::array<ResultRow, 1> rows = row_with_budget("abc");
  BudgetLine& mesh = rows[0].budget->lines[0];
  mesh.gain = 0.5;
  mesh.seconds = std::nan("");
  EXPECT_THAT(markdown_budgets(rows), HasSubstr("| undecided | undecided | a, b |"));
  EXPECT_THAT(csv_budgets(rows), HasSubstr(",0.5,,,\n"));
  mesh.seconds = 2;
  EXPECT_THAT(markdown_budgets(rows), HasSubstr("| +2 | 0.25 | a, b |"));
  EXPECT_THAT(csv_budgets(rows), HasSubstr(",0.5,2,0.25,\n"));
  mesh.seconds = 3;  // all digits, as of the numbers beside it
  EXPECT_THAT(csv_budgets(rows), HasSubstr(",0.5,3,0.16666666666666666,\n"));
  mesh.seconds = -2;
  EXPECT_THAT(markdown_budgets(rows), HasSubstr("| -2 | free | a, b |"));
}

TEST(UnitBudgetTables, NoTextIsAFormulaToASpreadsheet) {
  const std::string csv = csv_budgets(row_with_budget("=cmd"));
  EXPECT_THAT(csv, HasSubstr("\n'=cmd,fourier,"));
  EXPECT_THAT(csv, HasSubstr("field,,,,,,,,,'=none\n"));
}

TEST(UnitBudgetTables, WithoutBudgetsThereIsNoTable) {
  EXPECT_THAT(csv_budgets(std::array<ResultRow, 1>()), IsEmpty());
}

}  // namespace
}  // namespace pellucid::compare
