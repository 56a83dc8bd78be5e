// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/figure/plots/plot_scale.h"

#include <gmock/gmock.h>

#include <cmath>

namespace pellucid::compare {
namespace {

using ::testing::ElementsAre;

std::vector<std::string> labels(const PlotScale& scale) {
  std::vector<std::string> labels;
  for (const PlotTick& tick : scale.ticks()) {
    std::string& label = labels.emplace_back();
    for (const TextRun& run : tick.label) label += (run.is_raised ? "^" : "") + run.text;
  }
  return labels;
}

TEST(UnitPlotScale, LinearTicksAreRoundAndTheEndsAreTicks) {
  const PlotScale scale({3, 47}, {"", false}, 100);
  EXPECT_THAT(labels(scale), ElementsAre("0", "10", "20", "30", "40", "50"));
  EXPECT_DOUBLE_EQ(scale.at(0), 0);
  EXPECT_DOUBLE_EQ(scale.at(25), 50);
  EXPECT_DOUBLE_EQ(scale.ticks().back().at, 100);
}

TEST(UnitPlotScale, OfFewDecadesThereAreTwosAndFives) {
  const PlotScale scale({9, 110}, {"", true}, 100);
  EXPECT_THAT(labels(scale), ElementsAre("10", "20", "50", "100"));
  // A decade is the same length wherever it is.
  EXPECT_NEAR(scale.at(100) - scale.at(10), 1 / (1.08 * std::log10(110 / 9.)) * 100, 1e-9);
}

TEST(UnitPlotScale, OfManyDecadesOnlyPowersOfTen) {
  const PlotScale scale({1e-6, 1}, {"", true}, 100);
  EXPECT_THAT(labels(scale), ElementsAre("10^−6", "10^−5", "10^−4", "0.001", "0.01", "0.1", "1"));
  EXPECT_LE(labels(PlotScale({1e-20, 1e20}, {"", true}, 100)).size(), 12u);
}

TEST(UnitPlotScale, WhatHasNoLogarithmStandsOnARail) {
  const PlotScale none({1, 1000}, {"", true, 0}, 100);
  EXPECT_EQ(none.rail(), 0);
  const PlotScale scale({0, 1e-9, 1e-4, 1}, {"", true, 1e-7}, 100);
  EXPECT_GT(scale.rail(), 0);
  EXPECT_EQ(labels(scale).front(), "≤ 10^−7");
  EXPECT_EQ(scale.at(0), scale.rail() / 2);
  EXPECT_EQ(scale.at(1e-9), scale.rail() / 2);
  EXPECT_GT(scale.at(1e-4), scale.rail());
  EXPECT_LT(scale.at(1), 100);
}

TEST(UnitPlotScale, EqualNumbersHaveAnAxisAroundThem) {
  for (const double number : {-4.0, 0.0, 3.0}) {
    const PlotScale scale({number, number}, {"", false}, 100);
    EXPECT_GE(scale.ticks().size(), 2u) << number;
    EXPECT_GE(scale.at(number), 0) << number;
    EXPECT_LE(scale.at(number), 100) << number;
  }
  const PlotScale logarithmic({20, 20}, {"", true}, 100);
  EXPECT_NEAR(logarithmic.at(20), 50, 1e-9);
}

TEST(UnitPlotScale, NothingFiniteHasTicksAllTheSame) {
  for (const bool is_log : {false, true}) {
    const PlotScale scale({NAN, INFINITY}, {"", is_log}, 100);
    for (const PlotTick& tick : scale.ticks()) EXPECT_TRUE(std::isfinite(tick.at));
  }
}

TEST(PropertyPlotScale, TicksLieOnTheAxisAndAscend) {
  for (const bool is_log : {false, true})
    for (double low = 1e-8; low < 1e8; low *= 3.7)
      for (double high = 1.5 * low; high < 1e12; high *= 17) {
        const PlotScale scale({low, high}, {"", is_log}, 200);
        double last = -1e-6;
        for (const PlotTick& tick : scale.ticks()) {
          EXPECT_GT(tick.at, last);
          EXPECT_LE(tick.at, 200 + 1e-6);
          last = tick.at;
        }
        EXPECT_GE(scale.ticks().size(), 1u) << low << ' ' << high;
        EXPECT_GE(scale.at(low), -1e-6);
        EXPECT_LE(scale.at(high), 200 + 1e-6);
      }
}

}  // namespace
}  // namespace pellucid::compare
