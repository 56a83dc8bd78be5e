// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/budget/split_error.h"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <numeric>
#include <random>

namespace pellucid::compare {
namespace {

using ::testing::ElementsAre;

bool has(StageSet set, std::size_t stage) { return set & (1u << stage); }

/// Seconds that are known to a tenth.
Spread about(double seconds) {
  return {seconds, seconds - 0.1, seconds + 0.1, Interval{seconds - 0.1, seconds + 0.1}};
}

/// Pictures of one value each, which a function of the refined stages gives.
SplitError split(const StageOrder& order, const std::function<double(StageSet)>& value) {
  std::map<StageSet, DrawnPicture> pictures;
  for (const StageSet set : sets_to_draw(order))
    pictures[set] = {Image(3, 2, Rgba(glm::vec3(float(value(set))), 1.f)), about(set + 1), 0, {}};
  return split_error(order, pictures);
}

double sum_of_shares(const ErrorBudget& budget) {
  return std::accumulate(budget.lines.begin(), budget.lines.end(), budget.interaction,
                         [](double sum, const BudgetLine& line) { return sum + line.share; });
}

TEST(UnitSplitError, StagesThatAddHaveTheirParts) {
  const StageOrder order(3);
  const double parts[] = {0.5, 0.25, -0.125};
  const SplitError result = split(order, [&](StageSet set) {
    double left = 1;
    for (std::size_t i = 0; i < 3; ++i) left -= has(set, i) ? parts[i] : 0;
    return left;
  });
  EXPECT_EQ(result.budget.rmse, 0.625);
  for (std::size_t i = 0; i < 3; ++i) {
    const BudgetLine& line = result.budget.lines[i];
    EXPECT_EQ(line.share, parts[i] / 0.625);
    EXPECT_EQ(line.first, line.last);
    EXPECT_EQ(line.rmse, std::abs(parts[i]));
    EXPECT_EQ(line.gain, parts[i]);  // the whole stays above 0
    EXPECT_EQ(line.seconds, double(1u << i));
    EXPECT_EQ(result.amounts[i].at(1, 1), std::abs(parts[i]));
  }
  EXPECT_NEAR(result.budget.interaction, 0, 1e-15);
  EXPECT_EQ(result.budget.seconds, 1);
}

TEST(UnitSplitError, WhatTwoDoTogetherIsSharedEqually) {
  const SplitError result = split(
      StageOrder(2), [](StageSet set) { return (has(set, 0) ? 1 : 2) * (has(set, 1) ? 1 : 4); });
  // From 8 to 1: a stage alone 8 - 4 = 4 and 8 - 2 = 6, after the other 4 - … = 2 - 1 and 4 - 1.
  EXPECT_DOUBLE_EQ(result.budget.lines[0].first, 4 / 7.0);
  EXPECT_DOUBLE_EQ(result.budget.lines[0].last, 1 / 7.0);
  EXPECT_DOUBLE_EQ(result.budget.lines[1].first, 6 / 7.0);
  EXPECT_DOUBLE_EQ(result.budget.lines[1].last, 3 / 7.0);
  EXPECT_NEAR(result.budget.interaction, 0, 1e-15);
}

TEST(UnitSplitError, WhatThreeDoTogetherIsLeftOver) {
  const SplitError result = split(StageOrder(3), [](StageSet set) {
    return (has(set, 0) ? 1 : 2) * (has(set, 1) ? 1 : 2) * (has(set, 2) ? 1 : 2);
  });
  for (const BudgetLine& line : result.budget.lines) {
    EXPECT_DOUBLE_EQ(line.first, 4 / 7.0);
    EXPECT_DOUBLE_EQ(line.last, 1 / 7.0);
    EXPECT_DOUBLE_EQ(line.share, 2.5 / 7);
  }
  EXPECT_NEAR(result.budget.interaction, -0.5 / 7, 1e-15);
}

TEST(UnitSplitError, AChainIsRefinedInItsOrder) {
  const StageOrder order{std::nullopt, 0};
  EXPECT_THAT(sets_to_draw(order), ElementsAre(0b00, 0b01, 0b11));
  const SplitError result = split(order, [](StageSet set) {
    return set == 0 ? 10 : set == 1 ? 4 : 1;
  });
  EXPECT_DOUBLE_EQ(result.budget.lines[0].share, 6 / 9.0);
  EXPECT_DOUBLE_EQ(result.budget.lines[1].share, 3 / 9.0);
  EXPECT_EQ(result.budget.lines[1].gain, 3);     // upon the first
  EXPECT_EQ(result.budget.lines[1].seconds, 2);  // 4 - 2
  EXPECT_NEAR(result.budget.interaction, 0, 1e-15);
}

// A stage whose error lies where the whole has none changes the picture, and has no share of it
// but its own square.
TEST(UnitSplitError, ErrorsInOtherPixelsKeepTheirSquares) {
  std::map<StageSet, DrawnPicture> pictures;
  for (StageSet set = 0; set < 4; ++set) {
    pictures[set].image = Image(2, 1, Rgba(0));
    if (!has(set, 0)) pictures[set].image.at(0, 0).r = 3;
    if (!has(set, 1)) pictures[set].image.at(1, 0).r = 4;
  }
  const SplitError result = split_error(StageOrder(2), pictures);
  EXPECT_DOUBLE_EQ(result.budget.lines[0].share, 9 / 25.0);
  EXPECT_DOUBLE_EQ(result.budget.lines[1].share, 16 / 25.0);
  EXPECT_DOUBLE_EQ(result.budget.rmse, 5 / std::sqrt(6.0));
}

TEST(UnitSplitError, WithoutAnErrorThereAreNoShares) {
  const SplitError result = split(StageOrder(2), [](StageSet) { return 0.5; });
  EXPECT_EQ(result.budget.rmse, 0);
  EXPECT_EQ(result.budget.lines[0].share, 0);
  EXPECT_EQ(result.budget.interaction, 0);
}

/// Random pictures whose stages act alone and in pairs, the last one upon the first.
TEST(PropertySplitError, PairsAddUpToTheWhole) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 20; ++trial) {
    constexpr std::size_t stages = 5, pixels = 6;
    double alone[stages][pixels], together[stages][stages][pixels];
    for (auto& of_stage : alone) std::ranges::generate(of_stage, [&] { return normal(random); });
    for (auto& of_stage : together)
      for (auto& pair : of_stage) std::ranges::generate(pair, [&] { return normal(random); });
    StageOrder order(stages);
    if (trial % 2) order.back() = 0;
    std::map<StageSet, DrawnPicture> pictures;
    for (const StageSet set : sets_to_draw(order)) {
      Image image(int(pixels), 1, Rgba(0));
      for (std::size_t p = 0; p < pixels; ++p) {
        double value = 0;
        for (std::size_t i = 0; i < stages; ++i)
          for (std::size_t j = 0; j <= i; ++j)
            if (has(set, i) && has(set, j)) value += i == j ? alone[i][p] : together[i][j][p];
        image.pixels[p].g = float(value);
      }
      pictures[set].image = std::move(image);
    }
    const SplitError result = split_error(order, pictures);
    // Pictures are float: each of the twelve is rounded by 6e-8 of its values, of some ten.
    EXPECT_NEAR(result.budget.interaction, 0, 1e-5) << trial;
    EXPECT_NEAR(sum_of_shares(result.budget), 1, 1e-12) << trial;
  }
}

/// Whether the time of the one stage that there is counts as decided.
bool is_decided(const DrawnPicture& drawn, const DrawnPicture& refined) {
  const auto of_value = [](float value, DrawnPicture picture) {
    picture.image = Image(1, 1, Rgba(value, value, value, 1));
    return picture;
  };
  const SplitError result =
      split_error(StageOrder(1), {{0, of_value(1, drawn)}, {1, of_value(0, refined)}});
  return !std::isnan(result.budget.lines[0].seconds);
}

TEST(UnitSplitError, TimesDecideWhereTheirIntervalsAreApart) {
  EXPECT_TRUE(is_decided({{}, about(1), 0, {}}, {{}, about(1.3), 0, {}}));
  EXPECT_FALSE(is_decided({{}, about(1), 0, {}}, {{}, about(1.1), 0, {}}));
  const Spread once{9, 9, 9, std::nullopt};
  EXPECT_FALSE(is_decided({{}, about(1), 0, {}}, {{}, once, 0, {}}));
}

TEST(UnitSplitError, ASceneOfBothPicturesCostsThemTheSame) {
  const Spread vague{50, 1, 99, Interval{1, 99}};
  EXPECT_TRUE(is_decided({{}, about(1), 0, vague}, {{}, about(1.3), 0, vague}));
  EXPECT_FALSE(is_decided({{}, about(1), 0, vague}, {{}, about(1.3), 1, vague}));
  EXPECT_TRUE(is_decided({{}, about(1), 0, about(2)}, {{}, about(1), 1, about(3)}));
}

TEST(UnitSplitError, OnlyFirstStepsAreTimed) {
  EXPECT_EQ(sets_to_time(StageOrder(2)), (std::set<StageSet>{0, 1, 2}));
  EXPECT_EQ(sets_to_time({std::nullopt, 0}), (std::set<StageSet>{0, 1, 3}));
}

}  // namespace
}  // namespace pellucid::compare
