// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/run/tune.h"

#include <gmock/gmock.h>

#include "compare/methods/methods.h"
#include "compare/methods/sweep.h"
#include "core/error.h"
#include "core/options/names.h"
#include "tests/compare/fake_methods.h"
#include "tests/compare/study_folder.h"

namespace pellucid::compare {
namespace {

using ::testing::ElementsAre;
using namespace testing;

MethodCall fake(std::string_view name, const RawOptions& options = {}) {
  const scene::MethodRow& row = find_row("method", name, fake_methods());
  return {&row, Parameters(row.name, row.parameters, options)};
}

/// The fakes cost the same, so that the cheapest is the first that was given.
class UnitTune : public ::testing::Test {
 protected:
  TuneOutcome run(const ErrorBound& bound) const {
    return tune({.scene = folder_ / "one.json",
                 .reference = fake("truth"),
                 .candidates = {fake("broken"), fake("shifted", {{"by", "0.5"}}),
                                fake("exact-shifted"), fake("shifted", {{"by", "0.125"}})},
                 .bound = bound,
                 .repeats = 1,
                 .context = {},
                 .progress = {},
                 .on_row = {}});
  }
  StudyFolder folder_;
};

TEST_F(UnitTune, FindsTheFirstOfThoseWithinTheBound) {
  // `shifted` by x has an RMSE of exactly x; `exact-shifted` is off by 0.125.
  const TuneOutcome outcome = run({.max_rmse = 0.125, .min_ssim = {}, .max_bytes = {}});
  EXPECT_THAT(outcome.within_bound, ElementsAre(false, true, true, false));
  ASSERT_TRUE(outcome.best());
  EXPECT_EQ(outcome.best()->method, "exact-shifted");
  EXPECT_EQ(outcome.rows.back().method, "broken");
  EXPECT_NE(outcome.rows.back().error, "");
}

TEST_F(UnitTune, NoneIsWithinABoundThatAllMiss) {
  EXPECT_FALSE(run({.max_rmse = 0.1249, .min_ssim = {}, .max_bytes = {}}).best());
  EXPECT_FALSE(run({.max_rmse = 1, .min_ssim = 1, .max_bytes = {}}).best());
  EXPECT_FALSE(run({.max_rmse = 1, .min_ssim = {}, .max_bytes = 1023}).best());
  EXPECT_TRUE(run({.max_rmse = 1, .min_ssim = {}, .max_bytes = 1024}).best());
}

TEST_F(UnitTune, ABoundOfNothingIsRefused) {
  EXPECT_THROW(run({.max_rmse = {}, .min_ssim = {}, .max_bytes = 1024}), InputError);
  EXPECT_THROW(run({.max_rmse = -1, .min_ssim = {}, .max_bytes = {}}), InputError);
  EXPECT_THROW(run({.max_rmse = {}, .min_ssim = 1.5, .max_bytes = {}}), InputError);
}

TEST(UnitSweep, IsTheProductOfItsValues) {
  scene::MethodRow row = find_row("method", "shifted", fake_methods());
  row.sweep = "by=0|0.5,how=up|down";
  std::vector<std::string> texts;
  for (const MethodCall& call : sweep_of(row)) texts.push_back(call.text());
  EXPECT_THAT(texts, ElementsAre("shifted:by=0,how=up", "shifted:by=0,how=down",
                                 "shifted:by=0.5,how=up", "shifted:by=0.5,how=down"));
  row.sweep = "";
  EXPECT_EQ(sweep_of(row).size(), 1u);
}

TEST(PropertyMethodSweep, EveryRowsValuesAreAccepted) {
  for (const scene::MethodRow& row : methods()) EXPECT_GE(sweep_of(row).size(), 1u) << row.name;
}

TEST(UnitSweep, AStarInAStudyIsEveryMethodInAllItsSettings) {
  const StudyFolder folder;
  const Study study = load_study(folder.study(R"(["*"])"), fake_methods());
  EXPECT_EQ(study.methods.size() + 1, fake_methods().size());  // the reference has its own cell
  const std::string but = R"([{"method": "*", "except": ["broken", "truth"]}])";
  EXPECT_EQ(load_study(folder.study(but), fake_methods()).methods.size() + 2,
            fake_methods().size());
  EXPECT_THROW(
      load_study(folder.study(R"([{"method": "*", "except": ["brken"]}])"), fake_methods()),
      InputError);
}

}  // namespace
}  // namespace pellucid::compare
