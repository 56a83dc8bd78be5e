// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/timing/timing_rule.h"

#include <gtest/gtest.h>

#include <iostream>
#include <random>
#include <vector>

#include "tests/compare/timing/noises.h"

namespace pellucid::compare {
namespace {

using namespace testing;

TEST(UnitTimingRule, AFixedNumberIsOverWhenItIsReached) {
  const TimingRule three = fixed_repeats(3);
  EXPECT_FALSE(is_over(std::vector<double>{1, 2}, three));
  EXPECT_TRUE(is_over(std::vector<double>{1, 2, 9}, three));
  EXPECT_TRUE(is_settled(std::vector<double>{1, 2, 9}, three));
}

// Five times' interval is all of them: from 0.95 to 1.05 of a median of 1.
TEST(UnitTimingRule, AWidthIsHowFarAnEndIsFromTheMedian) {
  const std::vector<double> times{0.95, 0.99, 1, 1.01, 1.05};
  EXPECT_TRUE(is_settled(times, {5, 50, 0.0501}));
  EXPECT_FALSE(is_settled(times, {5, 50, 0.0499}));
  EXPECT_FALSE(is_settled(times, {6, 50, 0.0501}));
  EXPECT_FALSE(is_settled(std::vector<double>{1, 1, 1, 1}, {1, 50, 0.1}));  // has no interval
}

TEST(UnitTimingRule, ABoundThatIsNotMetEndsAtTheMost) {
  const std::vector<double> times{1, 2, 3, 4, 5, 6};
  EXPECT_FALSE(is_over(times, {5, 7, 0.01}));
  EXPECT_TRUE(is_over(times, {5, 6, 0.01}));
  EXPECT_FALSE(is_settled(times, {5, 6, 0.01}));
}

// 4 and another 2 are within 6 s, not within 5.9; the first is drawn in any case.
TEST(UnitTimingRule, NoTimeBeginsThatWouldExceedTheSeconds) {
  TimingRule rule{5, 50, 0.01};
  rule.seconds = 6;
  EXPECT_FALSE(is_over(std::vector<double>{2, 2}, rule));
  EXPECT_TRUE(is_over(std::vector<double>{2, 2, 2}, rule));
  rule.seconds = 5.9;
  EXPECT_TRUE(is_over(std::vector<double>{2, 2}, rule));
  EXPECT_FALSE(is_settled(std::vector<double>{2, 2}, rule));
  rule.seconds = 0;
  EXPECT_FALSE(is_over({}, rule));
  EXPECT_TRUE(is_over(std::vector<double>{2}, rule));
}

TEST(UnitTimingRule, ASpreadHasItsEndsAndItsInterval) {
  const Spread spread = spread_of(std::vector<double>{4, 1, 2}, fixed_repeats(3));
  EXPECT_EQ(spread.median, 2);
  EXPECT_EQ(spread.min, 1);
  EXPECT_EQ(spread.max, 4);
  EXPECT_FALSE(spread.interval);
}

// The times stop where their interval is narrow, which spoils 95 % (see spread_of()); 2000 trials
// vary by 0.5 % (one standard deviation). Two in a hundred are allowed.
TEST(PropertyTimingRule, HoldsTheMedianOfSkewedNoiseIn95OfAHundredWhereItStops) {
  std::mt19937_64 random(2);
  for (const Noise& noise : skewed_noises())
    for (const double relative : {0.02, 0.05, 0.1}) {
      const TimingRule rule{5, 50, relative};
      constexpr int trials = 2000;
      int holding = 0, times_in_all = 0;
      for (int trial = 0; trial < trials; ++trial) {
        std::vector<double> times;
        while (!is_over(times, rule)) times.push_back(noise.draw(random));
        const Interval interval = *spread_of(times, rule).interval;
        holding += interval.low <= noise.median && noise.median <= interval.high;
        times_in_all += int(times.size());
      }
      const double part = double(holding) / trials;
      std::cout << noise.name << ", to within " << 100 * relative << " %: " << part << " after "
                << double(times_in_all) / trials << " times\n";
      EXPECT_NEAR(part, 0.95, 0.02) << noise.name << ' ' << relative;
    }
}

}  // namespace
}  // namespace pellucid::compare
