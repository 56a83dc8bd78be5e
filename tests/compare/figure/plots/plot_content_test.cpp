// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/figure/plots/plot_content.h"

#include <gmock/gmock.h>

#include <cmath>

#include "core/error.h"
#include "tests/compare/study/result_rows.h"

namespace pellucid::compare {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

/// A row of an error, and of a time in milliseconds.
ResultRow timed(const char* scene, const char* method, double rmse, double ms) {
  ResultRow made = row(scene, method, rmse);
  made.seconds.median = ms / 1e3;
  made.steps = {{"all", made.seconds}};
  return made;
}

ResultRow swept(const char* bands, double rmse) {
  ResultRow made = timed("a", "fourier", rmse, 10);
  made.parameters = std::string("bands=") + bands;
  made.parameter_values = {{"bands", bands}, {"precision", "32"}};
  return made;
}

class UnitPlotContent : public ::testing::Test {
 protected:
  UnitPlotContent() {
    run_.rows = {timed("a", "exact", 0, 50), timed("a", "quick", 0.5, 1),
                 timed("a", "slow", 0.1, 9), timed("a", "beaten", 0.2, 20),
                 timed("b", "quick", 0.25, 2)};
    run_.rows[0].reference = true;
  }
  std::string error(const PlotRequest& request) const {
    try {
      read_plot(run_, request);
    } catch (const InputError& error) {
      return error.what();
    }
    return "none";
  }

  PastRun run_{"", "study", {}};
};

TEST_F(UnitPlotContent, ATradeOffHasAMarkForEachCallAndTheFrontOfThoseThatNoneBeats) {
  const Plot plot = read_plot(run_, {.scenes = {"a"}});
  EXPECT_EQ(plot.x.title, "Time [ms]");
  EXPECT_EQ(plot.y.title, "RMSE");
  EXPECT_TRUE(plot.x.logarithmic && plot.y.logarithmic);
  ASSERT_EQ(plot.panels.size(), 1u);
  const PlotPanel& panel = plot.panels[0];
  ASSERT_EQ(panel.series.size(), 3u);
  EXPECT_EQ(panel.series[1].label, "slow");
  EXPECT_THAT(panel.series[1].points, ElementsAre(Vec2(9, 0.1)));
  EXPECT_THAT(panel.front, ElementsAre(Vec2(1, 0.5), Vec2(9, 0.1)));
  EXPECT_THAT(panel.verticals, ElementsAre(50));
  EXPECT_EQ(plot.of_verticals, "exact, the reference");
}

TEST_F(UnitPlotContent, EachSceneHasAPanelAndAMethodOneSeries) {
  run_.rows.push_back(swept("2", 0.3));
  run_.rows.push_back(swept("5", 0.2));
  const Plot plot = read_plot(run_, {});
  ASSERT_EQ(plot.panels.size(), 2u);
  EXPECT_EQ(plot.panels[1].title, "b");
  EXPECT_EQ(plot.panels[0].series.back().points.size(), 2u);
}

TEST_F(UnitPlotContent, ANumberThatIsBetterHigherHasItsFrontAbove) {
  for (ResultRow& row : run_.rows) row.metrics.linear[1] = 1 - *row.metrics.linear[0];
  const Plot plot = read_plot(run_, {.y = "ssim", .scenes = {"a"}});
  EXPECT_FALSE(plot.y.logarithmic);
  EXPECT_THAT(plot.panels[0].front, ElementsAre(Vec2(1, 0.5), Vec2(9, 0.9)));
}

TEST_F(UnitPlotContent, ASweepIsOverTheParameterThatDiffers) {
  for (const char* bands : {"10", "2", "5"})
    run_.rows.push_back(swept(bands, 1 / std::atof(bands)));
  const Plot plot = read_plot(run_, {.kind = "sweep:fourier", .scenes = {"a"}});
  EXPECT_EQ(plot.x.title, "bands");
  ASSERT_EQ(plot.panels[0].series.size(), 1u);
  EXPECT_TRUE(plot.panels[0].series[0].is_joined);
  EXPECT_THAT(plot.panels[0].series[0].points,
              ElementsAre(Vec2(2, 0.5), Vec2(5, 0.2), Vec2(10, 0.1)));
  run_.rows.back().parameter_values["precision"] = "16";
  EXPECT_THAT(error({.kind = "sweep:fourier", .scenes = {"a"}}),
              HasSubstr("differ in 2 parameters"));
}

TEST_F(UnitPlotContent, CurvesKeepTheirNamesAndLeaveOutWhatIsNoNumber) {
  run_.rows[1].curves = {
      {"layer error", "", "Error", "layers", "RMSE", {1, 2, 3}, {0.1, NAN, 0.3}}};
  const Plot plot = read_plot(run_, {.kind = "curves:layer error", .logarithmic_x = true});
  EXPECT_EQ(plot.x.title, "layers");
  EXPECT_TRUE(plot.x.logarithmic);
  ASSERT_EQ(plot.panels.size(), 1u);  // "b" has none
  EXPECT_EQ(plot.panels[0].series[0].label, "quick");
  EXPECT_THAT(plot.panels[0].series[0].points, ElementsAre(Vec2(1, 0.1), Vec2(3, 0.3)));
}

TEST_F(UnitPlotContent, WhatIsNotThereIsNamed) {
  EXPECT_THAT(error({.kind = "trade"}),
              HasSubstr("accepted: trade-off, sweep:METHOD, curves:NAME"));
  EXPECT_THAT(error({.scenes = {"c"}}), HasSubstr("--scene: unknown scene 'c'"));
  EXPECT_THAT(error({.methods = {"quik"}}), HasSubstr("quick"));
  EXPECT_THAT(error({.x = "secnds"}), HasSubstr("seconds"));
  EXPECT_THAT(error({.kind = "curves:layers"}), HasSubstr("unknown curve 'layers'"));
  EXPECT_THAT(error({.kind = "sweep:quick", .scenes = {"a"}}), HasSubstr("1 of its calls"));
  EXPECT_THAT(error({.y = "flip"}), HasSubstr("no row has its numbers"));
}

TEST_F(UnitPlotContent, FailedRowsAreLeftOut) {
  run_.rows[1].error = "lost";
  const Plot plot = read_plot(run_, {.scenes = {"a"}});
  EXPECT_EQ(plot.panels[0].series.front().label, "slow");
}

TEST_F(UnitPlotContent, TheTableHasEveryPointWithAllDigits) {
  run_.rows[1].metrics.linear[0] = 1.0 / 3;
  EXPECT_EQ(csv_of(read_plot(run_, {.scenes = {"a"}, .methods = {"quick"}})),
            "scene,label,Time [ms],RMSE\na,quick,1,0.3333333333333333\n");
}

}  // namespace
}  // namespace pellucid::compare
