// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/run/tune.h"

#include <gmock/gmock.h>

#include <chrono>
#include <thread>

#include "compare/methods/methods.h"
#include "compare/methods/sweep.h"
#include "compare/results/measure_columns.h"
#include "compare/run/entrants.h"
#include "core/error.h"
#include "core/options/names.h"
#include "tests/compare/fake_methods.h"
#include "tests/compare/study_folder.h"

namespace pellucid::compare {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
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

/// Of as many bytes all are tied, in every run, and the least error goes first.
TEST_F(UnitTune, BytesAreNoMatterOfChance) {
  const TuneOutcome outcome =
      tune({.scene = folder_ / "one.json",
            .reference = fake("truth"),
            .candidates = {fake("shifted", {{"by", "0.5"}}), fake("exact-shifted"), fake("truth")},
            .bound = {.max_rmse = 0.5, .min_ssim = {}, .max_bytes = {}},
            .cost = Cost::bytes,
            .repeats = 30,
            .context = {},
            .progress = {},
            .on_row = {}});
  ASSERT_TRUE(outcome.best());
  EXPECT_EQ(outcome.best()->method, "truth");
  EXPECT_THAT(outcome.within_bound, ElementsAre(true, true, true));
  EXPECT_THAT(outcome.tied, ElementsAre(false, true, true));
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

/// A method of given times, the first the small picture's, bytes and shift of the picture.
struct Timed {
  const char* name;
  double small_seconds, seconds;
  std::uint64_t bytes;
  float shift;
};

constexpr Timed timed[] = {{"quick", 0.01, 0.1, 500, 0.125f},  {"as-quick", 0.01, 0.1, 400, 0.125f},
                           {"slow", 0.04, 0.15, 300, 0.0625f}, {"slower", 0.05, 0.5, 200, 0},
                           {"hopeless", 0.2, 3, 100, 0},       {"wrong", 0.001, 0.002, 10, 0.5f}};

class TimedRenderer final : public scene::Renderer {
 public:
  TimedRenderer(const scene::Scene& scene, const Timed& of) : scene_(scene), timed_(of) {}

  scene::Rendering render(const scene::RenderRequest&) override {
    scene::Rendering rendering;
    rendering.image = Image(scene_.width, scene_.height, Rgba(timed_.shift));
    rendering.layers = CountImage(scene_.width, scene_.height, 0);
    rendering.layers.at(0, 0) = 1;
    const bool small = scene_.width < 24;
    rendering.stats.steps = {{"all", small ? timed_.small_seconds : timed_.seconds}};
    rendering.stats.bytes = {{"all", timed_.bytes}};
    return rendering;
  }
  std::vector<std::string> explain() const override { return {}; }

 private:
  const scene::Scene& scene_;
  const Timed& timed_;
};

template <std::size_t i>
Made make_timed(const scene::Scene& scene, const Parameters&, const scene::RenderContext&) {
  return std::make_unique<TimedRenderer>(scene, timed[i]);
}

std::span<const scene::MethodRow> timed_methods() {
  static const scene::MethodRow rows[] = {
      fake_row(timed[0].name, false, make_timed<0>), fake_row(timed[1].name, false, make_timed<1>),
      fake_row(timed[2].name, false, make_timed<2>), fake_row(timed[3].name, true, make_timed<3>),
      fake_row(timed[4].name, true, make_timed<4>),  fake_row(timed[5].name, false, make_timed<5>)};
  return rows;
}

class UnitTuneRounds : public ::testing::Test {
 protected:
  UnitTuneRounds()
      : request{.scene = folder_ / "one.json",
                .reference = {&timed_methods()[3], Parameters("slower", {}, {})},
                .candidates = calls_that_fit("", timed_methods()),
                .bound = {.max_rmse = 0.2, .min_ssim = {}, .max_bytes = {}},
                .context = {},
                .progress = {},
                .on_row = {}} {}

  static std::vector<std::string> tied(const TuneOutcome& outcome) {
    std::vector<std::string> calls;
    for (std::size_t i = 0; i < outcome.rows.size(); ++i)
      if (outcome.tied[i]) calls.push_back(outcome.rows[i].call());
    return calls;
  }
  static const ResultRow& row(const TuneOutcome& outcome, const std::string& call) {
    return *std::ranges::find_if(outcome.rows, [&](const auto& r) { return r.call() == call; });
  }

  StudyFolder folder_;
  TuneRequest request;
};

// 100 ms twice, 150 ms within twice of it, 500 ms not.
TEST_F(UnitTuneRounds, EqualsAreTiedAndTheFewestBytesDecide) {
  const TuneOutcome outcome = tune(request);
  ASSERT_TRUE(outcome.best());
  EXPECT_EQ(outcome.best()->call(), "as-quick");
  EXPECT_THAT(tied(outcome), ElementsAre("quick"));
  EXPECT_EQ(row(outcome, "quick").seconds.interval->high, 0.1);
}

TEST_F(UnitTuneRounds, WhoCannotWinIsTimedNoFurther) {
  const TuneOutcome outcome = tune(request);
  EXPECT_EQ(row(outcome, "wrong").repeats, 1);
  EXPECT_EQ(row(outcome, "slower").repeats, 2 + 5);  // five in turn with the quickest
  EXPECT_GE(row(outcome, "slow").repeats, 5);
  ASSERT_EQ(outcome.left_out.size(), 1u);  // 200 ms for the small one, 100 for another's whole one
  EXPECT_EQ(outcome.left_out[0].call, "hopeless");
  EXPECT_THAT(outcome.left_out[0].why, HasSubstr("took 200.0 ms, the whole one"));
}

TEST_F(UnitTuneRounds, TheReferenceCompetes) {
  request.bound.max_rmse = 0.01;
  const TuneOutcome outcome = tune(request);
  ASSERT_TRUE(outcome.best());
  EXPECT_EQ(outcome.best()->call(), "slower");
  EXPECT_THAT(tied(outcome), ElementsAre());
}

TEST_F(UnitTuneRounds, OfBytesTheFewestWinWhateverTheirTime) {
  request.cost = Cost::bytes;
  const TuneOutcome outcome = tune(request);
  EXPECT_EQ(outcome.best()->call(), "hopeless");
  EXPECT_THAT(tied(outcome), ElementsAre());
}

TEST_F(UnitTuneRounds, TheEstimateComesFirst) {
  std::vector<std::string> said;
  request.on_estimate = [&](const TuneEstimate& estimate) {
    said.push_back("estimate");
    EXPECT_EQ(estimate.candidates, 6u);
    EXPECT_GT(estimate.seconds, 2 * 0.5);  // of the whole pictures alone
  };
  request.on_row = [&](const ResultRow& row) { said.push_back(row.call()); };
  tune(request);
  EXPECT_THAT(said, ElementsAre("estimate", "wrong", "quick", "as-quick", "slow", "slower"));
}

TEST_F(UnitTuneRounds, WhenTheTimeIsOverOnlyTheReferencesOwnCallIsDrawn) {
  request.max_seconds = 1e-9;
  const TuneOutcome outcome = tune(request);
  ASSERT_EQ(outcome.rows.size(), 1u);
  EXPECT_EQ(outcome.rows[0].call(), request.reference.text());
  EXPECT_EQ(outcome.left_out.size(), 5u);
  EXPECT_THAT(outcome.left_out[0].why, HasSubstr("the time was over"));
}

/// Sleeps for a tenth of the time that it says.
class SlowlyTimed : public scene::Renderer {
 public:
  SlowlyTimed(const scene::Scene& scene, std::size_t i) : drawn_(scene, timed[i]) {}
  scene::Rendering render(const scene::RenderRequest& request) override {
    ++pictures;
    scene::Rendering rendering = drawn_.render(request);
    std::this_thread::sleep_for(std::chrono::duration<double>(0.1 * rendering.stats.seconds()));
    return rendering;
  }
  std::vector<std::string> explain() const override { return {}; }

  static inline int pictures = 0;

 private:
  TimedRenderer drawn_;
};

template <std::size_t i>
Made make_slowly(const scene::Scene& scene, const Parameters&, const scene::RenderContext&) {
  return std::make_unique<SlowlyTimed>(scene, i);
}

// The reference's two whole pictures take 100 ms: of the others no small one is begun after 9 ms,
// no whole one after 21 ms. Those that no time decided on are named, and of the estimate is the
// time that there is.
TEST_F(UnitTuneRounds, NoPictureIsBegunWhenTheTimeIsOver) {
  std::vector<scene::MethodRow> rows(timed_methods().begin(), timed_methods().end());
  rows[0].make = make_slowly<0>, rows[3].make = make_slowly<3>, rows[4].make = make_slowly<4>;
  request.reference = {&rows[3], Parameters("slower", {}, {})};
  request.candidates = {{&rows[0], Parameters("quick", {}, {})},
                        {&rows[3], Parameters("slower", {}, {})},
                        {&rows[4], Parameters("hopeless", {}, {})}};
  request.max_seconds = 0.03;
  std::optional<double> estimated;
  request.on_estimate = [&](const TuneEstimate& estimate) { estimated = estimate.seconds; };
  double told = 0;
  request.progress = [&](double fraction, std::string_view) { told = std::max(told, fraction); };
  SlowlyTimed::pictures = 0;
  const TuneOutcome outcome = tune(request);
  EXPECT_EQ(SlowlyTimed::pictures, 2);
  EXPECT_EQ(outcome.best()->call(), "slower");
  EXPECT_EQ(outcome.best()->metrics.linear.of("rmse"), 0);
  EXPECT_EQ(estimated, 0.03);
  std::vector<std::string> undecided;
  for (const LeftOut& out : outcome.left_out)
    if (out.undecided) undecided.push_back(out.call);
  EXPECT_THAT(undecided, ElementsAre("quick", "hopeless"));
}

// The one pixel with a layer is as wrong as all others; only there is no window for SSIM.
TEST_F(UnitTuneRounds, TheBoundMayBeThatOfTheCoveredPixels) {
  request.bound.covered = true;
  request.bound.max_rmse = 0.0625;
  const TuneOutcome outcome = tune(request);
  EXPECT_EQ(outcome.best()->call(), "slow");
  EXPECT_EQ(outcome.best()->metrics.linear.of("rmse_covered"), 0.0625);
  request.bound.min_ssim = 0.1;
  EXPECT_FALSE(tune(request).best());
}

TEST_F(UnitTuneRounds, WhoChoosesOpacitiesItselfDoesNotCompete) {
  scene::MethodRow choosing = timed_methods()[0];
  choosing.name = "choosing";
  choosing.promises.optimizes_opacity = true;
  request.candidates.push_back({&choosing, Parameters("choosing", {}, {})});
  const TuneOutcome outcome = tune(request);
  EXPECT_EQ(outcome.left_out[0].call, "choosing");
  EXPECT_THAT(outcome.left_out[0].why, HasSubstr("chooses opacities itself"));
  request.candidates = {request.candidates.back()};
  EXPECT_THROW(tune(request), InputError);
}

TEST(UnitEntrants, WithoutAnIsosurfaceItsMethodDrawsWhatTheReferenceDraws) {
  const auto call = [](std::string_view name) {
    const scene::MethodRow& row = find_row("method", name, methods());
    return MethodCall{&row, Parameters(row.name, row.parameters, {})};
  };
  scene::Scene scene;
  EXPECT_EQ(why_left_out(call("march"), call("raytrace"), scene),
            "without an isosurface it draws as raytrace does");
  EXPECT_FALSE(why_left_out(call("raytrace"), call("raytrace"), scene));
  EXPECT_FALSE(why_left_out(call("fourier"), call("raytrace"), scene));
  scene.objects.push_back({"level", scene::Isosurface{}});
  EXPECT_FALSE(why_left_out(call("march"), call("raytrace"), scene));
}

TEST(UnitEntrants, FitPatternsOfNamesAndOfCalls) {
  const auto fitting = [](std::string_view patterns) {
    std::vector<std::string> texts;
    for (const MethodCall& call : calls_that_fit(patterns, methods())) texts.push_back(call.text());
    return texts;
  };
  EXPECT_THAT(
      fitting("fourier:bands=1*,linked-list"),
      ElementsAre("linked-list", "fourier:bands=1", "fourier:bands=10", "fourier:bands=15"));
  EXPECT_THAT(fitting("raytrace"), ::testing::Contains("raytrace:precision=fast,stop-below=0.01"));
  EXPECT_GT(fitting("").size(), methods().size());
  EXPECT_THROW(calls_that_fit("furier", methods()), InputError);
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
  // The reference has its own cell, and a row with a file does nothing without one.
  EXPECT_EQ(study.methods.size() + 2, fake_methods().size());
  const std::string but = R"([{"method": "*", "except": ["broken", "truth"]}])";
  EXPECT_EQ(load_study(folder.study(but), fake_methods()).methods.size() + 3,
            fake_methods().size());
  EXPECT_THROW(
      load_study(folder.study(R"([{"method": "*", "except": ["brken"]}])"), fake_methods()),
      InputError);
}

}  // namespace
}  // namespace pellucid::compare
