// SPDX-License-Identifier: GPL-3.0-or-later
// Methods of random numbers: a row has the picture of one draw, and says where others lie.
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "compare/results/best_row.h"
#include "compare/run/tune.h"
#include "core/options/names.h"
#include "tests/compare/run/studies.h"

namespace pellucid::compare {
namespace {

using namespace pellucid::compare::testing;

/// A study of `drawn`, and of `shifted` by 0.5, in so many repeats.
ResultRow row_of_drawn(int repeats, const std::string& more = "") {
  const StudyFolder folder;
  const auto file = folder.study(R"(["drawn", "shifted:by=0.5"])",
                                 R"("repeats": )" + std::to_string(repeats) + more);
  StudyOptions options;
  options.folder = folder / "results";
  return row_of(run_study(load_study(file, fake_methods()), options), "one", "drawn");
}

TEST(UnitDraws, ARowIsOfTheFirstAndItsIntervalsOfAllFive) {
  const ResultRow row = row_of_drawn(2);
  EXPECT_DOUBLE_EQ(*row.metrics.linear.of("rmse"), 0.375);
  const Interval rmse = row.metric_intervals.at("rmse");
  EXPECT_DOUBLE_EQ(rmse.low, 0.125);
  EXPECT_DOUBLE_EQ(rmse.high, 0.625);
}

TEST(PropertyDraws, HowOftenARowIsTimedChangesNoneOfItsErrors) {
  const auto errors = [](int repeats) {
    const nlohmann::json json = to_json(row_of_drawn(repeats));
    return std::pair(json["metrics"], json["metric_intervals"]);
  };
  const auto once = errors(1);
  for (const int repeats : {3, 5, 9}) EXPECT_EQ(errors(repeats), once) << repeats;
}

TEST(UnitDraws, OverViewsTheEndsAreMeans) {
  const ResultRow row = row_of_drawn(1, R"(, "views": 2)");
  EXPECT_DOUBLE_EQ(row.metric_intervals.at("rmse").high, 0.625);
}

TEST(UnitDraws, OtherMethodsHaveNone) {
  const StudyFolder folder;
  const StudyOutcome outcome = run(folder, R"(["shifted:by=0.5"])");
  EXPECT_TRUE(row_of(outcome, "one", "shifted").metric_intervals.empty());
}

TEST(PropertyDraws, IntervalsSurviveJson) {
  ResultRow row = row_of_drawn(1);
  row.metric_intervals["psnr"].high = std::numeric_limits<double>::infinity();
  const ResultRow again = row_from_json(to_json(row));
  EXPECT_EQ(again.metric_intervals.at("rmse").low, row.metric_intervals.at("rmse").low);
  EXPECT_EQ(again.metric_intervals.at("psnr").high, row.metric_intervals.at("psnr").high);
}

/// A row that errs by this, and lies there, or in the interval.
ResultRow row_at(const char* method, double rmse, std::optional<Interval> interval = {}) {
  ResultRow row;
  row.method = method;
  row.metrics.linear[0] = rmse;
  if (interval) row.metric_intervals["rmse"] = *interval;
  return row;
}

TEST(UnitDraws, WhereDrawsLieOnBothSidesOfAnotherTheTwoAreTied) {
  const Column& rmse = find_row("column", "rmse", columns());
  const ResultRow noisy = row_at("noisy", 0.3, Interval{0.2, 0.4});
  EXPECT_TRUE(are_tied(rmse, noisy, row_at("within", 0.35)));
  EXPECT_FALSE(are_tied(rmse, noisy, row_at("worse", 0.45)));
  const std::vector<ResultRow> rows{noisy, row_at("within", 0.35), row_at("worse", 0.45)};
  EXPECT_FALSE(is_undecided(rmse, rows));
  EXPECT_TRUE(is_among_best(rmse, rows[0], rows));
  EXPECT_TRUE(is_among_best(rmse, rows[1], rows));
  EXPECT_FALSE(is_among_best(rmse, rows[2], rows));
}

TEST(UnitDraws, ATableHasTheirInterval) {
  const Column& rmse = find_row("column", "rmse", columns());
  EXPECT_EQ(text_with_interval(rmse, row_at("noisy", 0.3, Interval{0.2, 0.4})),
            "3.00e-01 (2.00e-01–4.00e-01)");
  EXPECT_EQ(text_with_interval(rmse, row_at("other", 0.3)), "3.00e-01");
}

class UnitTuneOfDraws : public ::testing::Test {
 protected:
  bool is_within(double max_rmse) const {
    const auto call = [](std::string_view name) {
      return MethodCall{&find_row("method", name, fake_methods()), Parameters(name, {}, {})};
    };
    return tune({.scene = folder_ / "one.json",
                 .reference = call("truth"),
                 .candidates = {call("drawn")},
                 .bound = {.max_rmse = max_rmse, .min_ssim = {}, .max_bytes = {}},
                 .repeats = 1,
                 .context = {},
                 .progress = {},
                 .on_row = {}})
        .within_bound.at(0);
  }
  StudyFolder folder_;
};

// The first picture is off by 0.375, the worst of five by 0.625.
TEST_F(UnitTuneOfDraws, OneGoodDrawIsNotEnough) {
  EXPECT_FALSE(is_within(0.3));
  EXPECT_FALSE(is_within(0.4));
  EXPECT_TRUE(is_within(0.63));
}

}  // namespace
}  // namespace pellucid::compare
