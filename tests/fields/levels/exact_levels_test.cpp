// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/levels/exact_levels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/levels.h"

namespace pellucid::fields {
namespace {

using testing::sampled;

TEST(UnitSampleScale, KeepsTheOffsetAsZeroAndGivesValuesBack) {
  for (const double offset : {0.0, 0.1, -101325.0, 1e-310, 1.7e308}) {
    const SampleScale scale(offset, -std::abs(offset) * 1.01, std::abs(offset) * 1.01);
    EXPECT_EQ(scale.kept(offset), 0);
    EXPECT_EQ(scale.value(0), offset);
    for (const double share : {-1.0, 0.3, 0.999}) {
      const double value = share * offset;
      EXPECT_LE(std::abs(scale.kept(value)), 32);  // far below the largest float
      EXPECT_NEAR(scale.value(scale.kept(value)) / 2, value / 2, std::abs(offset) * 1e-15);
    }
  }
}

TEST(UnitExactLevels, OneOfDoublesMakesAllDoubles) {
  const auto tenth = [](const Vec3&) { return 0.1; };
  ExactLevels levels = std::vector{sampled(Vec3(0), 1, 3, tenth)};
  append(ExactLevels(std::vector{sampled(Vec3(2), 1, 3, tenth)}), levels);
  EXPECT_EQ(levels.index(), 0u);
  append(exact({sampled<double>(Vec3(4), 1, {3, 3, 3}, tenth)}), levels);
  ASSERT_EQ(levels.index(), 1u);
  const auto& doubles = std::get<1>(levels);
  ASSERT_EQ(doubles.size(), 3u);
  EXPECT_EQ(doubles[0].samples.front(), double(0.1f));
  EXPECT_EQ(doubles[2].samples.front(), 0.1);
  EXPECT_EQ(doubles[2].origin, Vec3(4));
  EXPECT_EQ(sample_range(levels), Vec2(0.1, 0.1f));
  append(ExactLevels(std::vector{sampled(Vec3(6), 1, 3, tenth)}), levels);
  EXPECT_EQ(std::get<1>(levels).size(), 4u);
}

/// Blocks side by side are joined where their samples are equal: one scale keeps them so.
TEST(UnitExactLevels, BlocksOfDoublesAreJoined) {
  const auto pressure = [](const Vec3& x) { return 101325 + 0.005 * x.x; };
  ExactLevels levels = exact({sampled<double>(Vec3(0), 0.5, {4, 4, 4}, pressure),
                              sampled<double>(Vec3(1.5, 0, 0), 0.5, {5, 4, 4}, pressure)});
  ScaledLevels samples = rounded(std::move(levels), 101325.0085);
  const LevelField field(std::move(samples.levels), find_reconstruction("blend"), {},
                         samples.scale);
  ASSERT_EQ(field.levels().size(), 1u);
  EXPECT_EQ(field.levels().front().size, (std::array{8, 4, 4}));
  EXPECT_NEAR(*field.height(Vec3(1.7, 1, 1), 101325.0085) / field.gradient(Vec3(1.7, 1, 1))->x, 0,
              1e-8);
}

}  // namespace
}  // namespace pellucid::fields
