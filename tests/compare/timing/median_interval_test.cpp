// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/timing/median_interval.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <random>

#include "tests/compare/timing/noises.h"

namespace pellucid::compare {
namespace {

using namespace testing;

TEST(UnitMedianInterval, TheMedianIsTheMiddleOrTheMeanOfTheMiddleTwo) {
  EXPECT_EQ(median_of({3, 1, 2}), 2);
  EXPECT_EQ(median_of({4, 1, 3, 2}), 2.5);
  EXPECT_EQ(median_of({7}), 7);
}

TEST(UnitMedianInterval, FewerThanFiveHaveNone) {
  EXPECT_FALSE(median_interval({1, 2, 3, 4}));
  EXPECT_TRUE(median_interval({1, 2, 3, 4, 5}));
}

// γ_1 of five is 1 - 2/32 < 0.95; of six 1 - 2/64 = 0.96875 is more, and γ_2 = 1 - 14/64 less.
TEST(UnitMedianInterval, OfFiveItIsAllOfThem) {
  const Interval interval = *median_interval({5, 1, 4, 2, 3});
  EXPECT_EQ(interval.low, 1);
  EXPECT_EQ(interval.high, 5);
}

TEST(UnitMedianInterval, BetweenOrderStatisticsItIsHettmanspergersAndSheathers) {
  const double part = (0.96875 - 0.95) / (0.96875 - 0.78125);
  const double lambda = 5 * part / (1 + 4 * part);
  const Interval interval = *median_interval({1, 2, 3, 4, 5, 6});
  EXPECT_NEAR(interval.low, 1 + lambda, 1e-12);  // of numbers below 10, a few ulp
  EXPECT_NEAR(interval.high, 6 - lambda, 1e-12);
}

// Of ten, γ_2 = 1 - 22/1024 = 0.979 and γ_3 = 1 - 112/1024 = 0.891.
TEST(UnitMedianInterval, OfTenItEndsBetweenTheSecondAndTheThird) {
  const double part = (1 - 22 / 1024. - 0.95) / (90 / 1024.);
  const double lambda = 8 * part / (2 + 6 * part);
  const Interval interval = *median_interval({1, 2, 3, 4, 5, 6, 7, 8, 9, 10});
  EXPECT_NEAR(interval.low, 2 + lambda, 1e-12);
  EXPECT_NEAR(interval.high, 9 - lambda, 1e-12);
}

// Of many values the binomial is normal: the ends stand 1.96 √n / 2 places from the middle, to
// within the one place by which a count is whole.
TEST(UnitMedianInterval, OfManyItIsTheNormalApproximation) {
  std::vector<double> values(5000);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = double(i);
  const Interval interval = *median_interval(values);
  EXPECT_NEAR(interval.low, 2499.5 - 1.96 * std::sqrt(5000) / 2, 1);
  EXPECT_NEAR(interval.high, 2499.5 + 1.96 * std::sqrt(5000) / 2, 1);
}

TEST(UnitMedianInterval, OverlapIsSharedEnds) {
  EXPECT_TRUE(overlap({1, 2}, {2, 3}));
  EXPECT_TRUE(overlap({1, 9}, {2, 3}));
  EXPECT_TRUE(overlap({2, 3}, {1, 9}));
  EXPECT_FALSE(overlap({1, 2}, {2.5, 3}));
  EXPECT_FALSE(overlap({2.5, 3}, {1, 2}));
}

// A part of 95 % of 4000 varies by 0.35 % (one standard deviation); two in a hundred are allowed.
TEST(PropertyMedianInterval, HoldsTheMedianOfSkewedNoiseIn95OfAHundred) {
  std::mt19937_64 random(1);
  for (const Noise& noise : skewed_noises())
    for (const std::size_t n : {6u, 7u, 10u, 20u, 50u}) {
      constexpr int trials = 4000;
      int holding = 0;
      for (int trial = 0; trial < trials; ++trial) {
        std::vector<double> times(n);
        for (double& time : times) time = noise.draw(random);
        const Interval interval = *median_interval(times);
        holding += interval.low <= noise.median && noise.median <= interval.high;
      }
      const double part = double(holding) / trials;
      std::cout << noise.name << ", n = " << n << ": " << part << '\n';
      EXPECT_NEAR(part, 0.95, 0.02) << noise.name << ' ' << n;
    }
}

}  // namespace
}  // namespace pellucid::compare
