// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "compare/methods/methods.h"
#include "compare/run/run_study.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::compare {
namespace {

using namespace pellucid::testing;

// A stage's share is half its first and half its last, so that stages which act alone and in pairs
// add up to the whole. A 20th is left to what three of them do together.
TEST(SlowBudgetStudy, TheStagesAddUpToWithinA20thOfTheError) {
  const TemporaryFolder folder;
  StudyOptions options;
  options.folder = folder / "budget";
  int budgets = 0;
  options.on_row = [&](const ResultRow& row) {
    ASSERT_EQ(row.error, "");
    ASSERT_TRUE(row.budget) << row.scene << '/' << row.call();
    double shares = 0;
    for (const BudgetLine& line : row.budget->lines) shares += line.share;
    std::cout << row.scene << '/' << row.call() << ": the stages " << shares << ", together "
              << row.budget->interaction << '\n';
    EXPECT_NEAR(shares + row.budget->interaction, 1, 1e-9);
    EXPECT_LT(std::abs(row.budget->interaction), 0.05);
    ++budgets;
  };
  run_study(load_study(find_study("budget"), methods()), options);
  EXPECT_EQ(budgets, 9);
}

}  // namespace
}  // namespace pellucid::compare
