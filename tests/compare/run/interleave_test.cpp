// SPDX-License-Identifier: GPL-3.0-or-later
// Cells of one scene, timed in turn.
#include "compare/run/interleave.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/options/names.h"
#include "tests/compare/run/studies.h"
#include "tests/compare/study_error.h"

namespace pellucid::compare {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using namespace pellucid::compare::testing;

/// Who rendered, in order; and the times of each, over and over.
std::vector<std::string> order;

class LoggingRenderer final : public scene::Renderer {
 public:
  LoggingRenderer(const scene::Scene& scene, std::string name, std::vector<double> times)
      : image_(scene.width, scene.height, Rgba(0.5f)),
        name_(std::move(name)),
        times_(std::move(times)) {}

  scene::Rendering render(const scene::RenderRequest& request) override {
    if (!request.layers) order.push_back(name_);
    if (name_ == "breaks" && renders_ == 2) throw WorkError("it broke");
    scene::Rendering rendering;
    rendering.image = image_;
    rendering.stats.steps = {{"all", times_[renders_++ % times_.size()]}};
    return rendering;
  }
  std::vector<std::string> explain() const override { return {}; }

 private:
  Image image_;
  std::string name_;
  std::vector<double> times_;
  std::size_t renders_ = 0;
};

Made make_steady(const scene::Scene& scene, const Parameters&, const scene::RenderContext&) {
  return std::make_unique<LoggingRenderer>(scene, "steady", std::vector{1.0});
}
Made make_wild(const scene::Scene& scene, const Parameters&, const scene::RenderContext&) {
  return std::make_unique<LoggingRenderer>(scene, "wild", std::vector{1.0, 3.0});
}
Made make_breaks(const scene::Scene& scene, const Parameters&, const scene::RenderContext&) {
  return std::make_unique<LoggingRenderer>(scene, "breaks", std::vector{1.0});
}

std::span<const scene::MethodRow> logging_methods() {
  static const scene::MethodRow rows[] = {fake_row("steady", true, make_steady),
                                          fake_row("wild", false, make_wild),
                                          fake_row("breaks", false, make_breaks)};
  return rows;
}

Cell cell_of(std::string_view name) {
  const scene::MethodRow& row = find_row("method", name, logging_methods());
  return {"s.json", "s", {&row, Parameters(row.name, row.parameters, {})}};
}

std::vector<MeasuredCell> measure(const std::vector<std::string>& names, const TimingRule& timing,
                                  int* rounds = nullptr) {
  order.clear();
  scene::Scene scene;
  scene.width = scene.height = 2;
  std::vector<Cell> cells;
  for (const std::string& name : names) cells.push_back(cell_of(name));
  const std::vector<scene::RenderContext> contexts(cells.size());
  return measure_interleaved(cells, scene, timing, contexts, [&] {
    if (rounds) ++*rounds;
  });
}

TEST(UnitInterleave, EachRoundTimesEachCellOnceAndBeginsWithAnother) {
  int rounds = 0;
  measure({"steady", "wild"}, fixed_repeats(3), &rounds);
  EXPECT_THAT(order, ElementsAre("steady", "wild", "wild", "steady", "steady", "wild"));
  EXPECT_EQ(rounds, 3);
}

TEST(UnitInterleave, ACellThatIsSettledStopsAndTheOthersGoOn) {
  const auto cells = measure({"steady", "wild"}, {5, 9, 0.05});
  const ResultRow& steady = cells[0].measurement->row;
  const ResultRow& wild = cells[1].measurement->row;
  EXPECT_EQ(steady.repeats, 5);
  EXPECT_EQ(steady.settled, true);
  EXPECT_EQ(steady.seconds.interval->low, 1);
  EXPECT_EQ(wild.repeats, 9);
  EXPECT_EQ(wild.settled, false);
}

TEST(UnitInterleave, ACellThatThrowsLeavesTheOthers) {
  const auto cells = measure({"breaks", "steady"}, fixed_repeats(4));
  EXPECT_FALSE(cells[0].measurement);
  EXPECT_THAT(cells[0].error, HasSubstr("it broke"));
  EXPECT_EQ(cells[1].measurement->row.repeats, 4);
}

TEST(UnitInterleave, TheFirstPictureIsApartFromTheTimedOnes) {
  const auto cells = measure({"wild"}, fixed_repeats(1));
  EXPECT_EQ(cells[0].measurement->row.first_seconds, 1);
  EXPECT_EQ(cells[0].measurement->row.seconds.median, 3);
}

StudyOutcome run_timed(const StudyFolder& folder, const std::string& more) {
  const auto file = folder.study(R"(["wild", "breaks"])", more);
  std::string text = read_text(file);
  text.replace(text.find("truth"), 5, "steady");
  write_text(file, text);
  StudyOptions options;
  options.folder = folder / "results";
  return run_study(load_study(file, logging_methods()), options);
}

TEST(UnitInterleave, AStudyWithTimingSaysWhatItCouldNotReach) {
  const StudyFolder folder;
  const StudyOutcome outcome = run_timed(folder, R"("timing": {"max": 7})");
  EXPECT_EQ(row_of(outcome, "one", "steady").repeats, 5);
  EXPECT_EQ(row_of(outcome, "one", "wild").repeats, 7);
  EXPECT_THAT(row_of(outcome, "two", "breaks").error, HasSubstr("it broke"));
  EXPECT_GE(row_of(outcome, "one", "wild").calibrations.size(), 7u);
  EXPECT_THAT(read_text(folder / "results/table.md"),
              HasSubstr("2 of 6 rows reached the most repeats"));
}

TEST(UnitInterleave, WithoutTimingCellsAreTimedOneAfterAnother) {
  const StudyFolder folder;
  order.clear();
  const StudyOutcome outcome = run_timed(folder, R"("repeats": 2)");
  EXPECT_THAT(std::vector(order.begin(), order.begin() + 4),
              ElementsAre("steady", "steady", "wild", "wild"));
  EXPECT_FALSE(row_of(outcome, "one", "wild").settled);
  EXPECT_EQ(row_of(outcome, "one", "wild").calibrations.size(), 2u);  // before and after
}

std::string timing_error(const std::string& more) { return study_error("[]", more); }

TEST(UnitTiming, AStudyAsksForItByKeys) {
  const StudyFolder folder;
  const auto timing = [&](const std::string& more) {
    return timing_of(load_study(folder.study("[]", more), fake_methods()));
  };
  const TimingRule usual = timing(R"("timing": {})");
  EXPECT_EQ(usual.min, 5);
  EXPECT_EQ(usual.max, 50);
  EXPECT_EQ(usual.relative, 0.05);
  EXPECT_EQ(timing(R"("timing": {"relative": 0.01, "min": 60})").max, 60);
  EXPECT_FALSE(usual.seconds);
  EXPECT_EQ(timing(R"("timing": {"seconds": 20})").seconds, 20);
  EXPECT_EQ(timing(R"("repeats": 9, "timing": {})").min, 9);  // repeats are the least then
  EXPECT_EQ(timing(R"("repeats": 9)").max, 9);
  EXPECT_FALSE(timing(R"("repeats": 9)").relative);
}

TEST(UnitTiming, BoundsThatCannotBeMetAreRefused) {
  EXPECT_THAT(timing_error(R"("timing": {"relativ": 1})"),
              HasSubstr("timing: unknown key 'relativ'"));
  EXPECT_THAT(timing_error(R"("timing": {"relative": 0})"),
              HasSubstr("timing.relative: 0; accepted"));
  EXPECT_THAT(timing_error(R"("timing": {"min": 4})"),
              HasSubstr("timing.min: 4; accepted: an integer, 5"));
  EXPECT_THAT(timing_error(R"("timing": {"seconds": -1})"),
              HasSubstr("timing.seconds: -1; accepted"));
  EXPECT_THAT(timing_error(R"("timing": {"min": 9, "max": 8})"),
              HasSubstr("timing.max: 8; accepted: an integer, 9"));
}

}  // namespace
}  // namespace pellucid::compare
