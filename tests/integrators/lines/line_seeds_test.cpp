// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/lines/line_seeds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace pellucid::integrators::test {
namespace {

std::vector<double> seeds(const LineSeeds& lines, int count) {
  std::vector<double> s;
  for (int i = 0; i < count; ++i) s.push_back(lines.seed(std::uint64_t(i)).s);
  std::sort(s.begin(), s.end());
  return s;
}

TEST(UnitLineSeeds, EvenSeedsLeaveNoGap) {
  for (const int count : {2, 7, 100, 1000, 4181}) {
    const std::vector<double> s = seeds(LineSeeds(), count);
    EXPECT_LT(s.front(), LineSeeds::largest_gap / count);
    EXPECT_LT(1 - s.back(), LineSeeds::largest_gap / count);
    for (int i = 1; i < count; ++i)
      EXPECT_LT(s[i] - s[i - 1], LineSeeds::largest_gap / count) << count << ' ' << i;
  }
  EXPECT_EQ(LineSeeds().seed(5).density, 1);
}

// Importance 3 s²: 0.1 s + 0.9 s³ of the lines start before s.
TEST(UnitLineSeeds, SeedsFollowTheImportance) {
  const LineSeeds lines([](double s) { return 3 * s * s; });
  constexpr int count = 10'000;
  const std::vector<double> s = seeds(lines, count);
  for (int i = 0; i < count; i += 100) {
    const double before = 0.1 * s[i] + 0.9 * std::pow(s[i], 3);
    // 64 intervals of trapezoids: (1/64)² / 12 times the slope's change, 6, and their chords: 1/8.
    EXPECT_NEAR(before, (i + 0.5) / count, 0.9 * 6 / (8. * 64 * 64) + 2. / count) << s[i];
  }
}

// Nearly all lines start in a peak that the first samples hardly see, with the density that it
// says.
TEST(UnitLineSeeds, FindsAPeak) {
  const LineSeeds lines([](double s) { return 1 / (1e-6 + std::pow(s - 0.3, 2)); });
  int inside = 0;
  for (int i = 0; i < 1000; ++i) {
    const LineSeeds::Seed seed = lines.seed(std::uint64_t(i));
    EXPECT_GE(seed.density, 0.1);
    if (std::abs(seed.s - 0.3) < 0.01) ++inside;
  }
  // A Cauchy distribution of width 1e-3: 2/π atan(10) = 0.94 of it within 0.01.
  EXPECT_NEAR(inside, 1000 * (0.9 * 0.94 + 0.1 * 0.02), 30);
}

TEST(UnitLineSeeds, NoImportanceIsEvenlySpread) {
  const LineSeeds none([](double) { return 0.; });
  for (std::uint64_t i = 0; i < 100; ++i) EXPECT_EQ(none.seed(i).s, LineSeeds().seed(i).s);
}

}  // namespace
}  // namespace pellucid::integrators::test
