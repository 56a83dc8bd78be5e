// SPDX-License-Identifier: GPL-3.0-or-later
// Where a march crosses a surface on levels: closed forms, what holds for any step, and the exact
// crossings. Whole pictures by it are in methods/march_test.cpp.

#include "groundtruth/levels/level_march.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/groundtruth/levels.h"

namespace pellucid::groundtruth {
namespace {

std::vector<double> marched(const fields::LevelField& field, double value, const WorldRay& ray,
                            const MarchOptions& options) {
  std::vector<double> at;
  LevelMarch(field, value, options).visit_crossings(ray, [&](double t) {
    at.push_back(t);
    return true;
  });
  return at;
}

/// Rays through random places of the nested field's cube.
std::vector<WorldRay> random_rays(std::size_t count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0.7, 7.3);
  const auto any = [&] { return Vec3(uniform(random), uniform(random), uniform(random)); };
  std::vector<WorldRay> rays;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 a = any(), b = any();
    rays.push_back({a, glm::normalize(b - a)});
  }
  return rays;
}

class PropertyLevelMarch : public ::testing::TestWithParam<fields::ReconstructionRow> {};
INSTANTIATE_TEST_SUITE_P(All, PropertyLevelMarch, ::testing::ValuesIn(fields::reconstructions),
                         [](const auto& row) { return std::string(row.param.name); });

TEST_P(PropertyLevelMarch, HalvingTheStepLosesNoCrossing) {
  // The samples of a step are among those of half of it, and of samples with fewer others between
  // them no fewer pairs differ in sign.
  const fields::LevelField field = nested(wavy, GetParam());
  std::size_t coarsest = 0, finest = 0;
  for (const WorldRay& ray : random_rays(100)) {
    std::size_t before = 0;
    for (const double steps : {0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0}) {
      const std::size_t found = marched(field, 0.05, ray, {.steps_per_cell = steps}).size();
      EXPECT_GE(found, before);
      before = found;
      if (steps == 0.25) coarsest += found;
    }
    finest += before;
  }
  EXPECT_LT(coarsest, finest);  // long steps lose some
}

TEST_P(PropertyLevelMarch, EmptySpaceSkippedChangesNothing) {
  const fields::LevelField field(
      {sampled(Vec3(0.5), 1, 24, wavy), sampled(Vec3(2.25), 0.5, 20, wavy)}, GetParam());
  std::size_t found = 0;
  for (const WorldRay& away : random_rays(200)) {
    const WorldRay ray{away.at(30), -away.direction};  // through empty blocks to the surface
    const auto all = marched(field, 0.9, ray, {.skip_empty = false});
    EXPECT_EQ(marched(field, 0.9, ray, {.skip_empty = true}), all);
    found += all.size();
  }
  EXPECT_GT(found, 20u);
}

TEST_P(PropertyLevelMarch, BisectionFindsTheExactCrossings) {
  const fields::LevelField field = nested(wavy, GetParam());
  std::size_t found = 0;
  for (const WorldRay& ray : random_rays(60)) {
    const auto exact = exact_crossings(field, 0.05, ray);
    for (const double t : marched(field, 0.05, ray,
                                  {.steps_per_cell = 16, .refinement = HitRefinement::bisection})) {
      ++found;
      // As for exact crossings: 1e-9 of the finest cell.
      EXPECT_TRUE(std::ranges::any_of(exact, [&](double other) {
        return std::abs(other - t) < 0.5e-9;
      })) << t;
    }
  }
  EXPECT_GT(found, 60u);
}

TEST(UnitLevelMarch, ASphereIsEnteredAndLeft) {
  const auto distance = [](const Vec3& x) { return glm::length(x - 4.0); };
  const fields::LevelField field({sampled(Vec3(0), 0.125, 65, distance)},
                                 fields::find_reconstruction("blend"));
  // Along the axis the samples' lines are those of the march: linear placement is exact up to
  // float, and so is bisection.
  for (const HitRefinement refinement : {HitRefinement::linear, HitRefinement::bisection}) {
    const auto at = marched(field, 2, {Vec3(-2, 4, 4), Vec3(1, 0, 0)}, {.refinement = refinement});
    ASSERT_EQ(at.size(), 2u);
    // Samples near 2 in float are off by 1.2e-7, and the slope is 1.
    EXPECT_NEAR(at[0], 4, 2.4e-7);
    EXPECT_NEAR(at[1], 8, 2.4e-7);
  }
}

// The field is 4 - x, above 2 from the volume's face to x = 2 and below beyond; then the same the
// other way round, which the ray enters between two samples.
TEST(UnitLevelMarch, TheReportsHitIsTheFirstSampleInside) {
  const auto falling = [](const Vec3& x) { return 4 - x.x; };
  const auto rising = [](const Vec3& x) { return x.x; };
  const MarchOptions as_reported{.steps_per_cell = 2, .refinement = HitRefinement::sample};
  const WorldRay ray{Vec3(-2, 4, 4), Vec3(1, 0, 0)};
  const fields::ReconstructionRow& trilinear = fields::find_reconstruction("trilinear");
  const fields::LevelField falls({sampled(Vec3(0), 1, 9, falling)}, trilinear),
      rises({sampled(Vec3(0), 1, 9, rising)}, trilinear);
  const auto inside_at_first = marched(falls, 2, ray, as_reported);
  ASSERT_EQ(inside_at_first.size(), 1u);  // the way out does not count
  EXPECT_NEAR(inside_at_first[0], 2, 1e-12);
  const auto entered = marched(rises, 2.1, ray, as_reported);
  ASSERT_EQ(entered.size(), 1u);
  EXPECT_NEAR(entered[0], 4.5, 1e-12);  // samples at x = 2 and 2.5
}

TEST(UnitLevelMarch, LinearPlacementConvergesAtOrderTwo) {
  // x y z is its own reconstruction, without a kink within the cell that the rays stay in, and
  // grows along rays of positive direction: the line through two samples a step h apart errs by
  // |f''| h² / 8 |f'| at most.
  const auto product = [](const Vec3& x) { return x.x * x.y * x.z; };
  const fields::LevelField field({sampled(Vec3(0), 8, 3, product)},
                                 fields::find_reconstruction("trilinear"));
  double before = 0;
  for (const double steps : {4.0, 16.0, 64.0}) {
    double worst = 0;
    for (const WorldRay& any : random_rays(60)) {
      const WorldRay ray{Vec3(0.5), glm::abs(any.direction) + 0.2};
      const auto exact = exact_crossings(field, 30, ray);
      const auto at = marched(field, 30, ray, {.steps_per_cell = steps});
      ASSERT_EQ(exact.size(), 1u);
      ASSERT_EQ(at.size(), 1u);
      worst = std::max(worst, std::abs(at[0] - exact[0]));
    }
    if (before > 0) {
      EXPECT_LT(worst, before / 12);  // 16, where h is short enough for h³ not to count
    }
    before = worst;
  }
  EXPECT_GT(before, 0);
}

TEST(UnitLevelMarch, CrossingsCloserThanAStepAreLost) {
  // |x - 4.5| < 0.25 lies between the samples of steps of a cell, and is found by shorter ones.
  const auto slab = [](const Vec3& x) { return std::abs(x.x - 4.5); };
  const fields::LevelField field({sampled(Vec3(0), 0.5, 17, slab)},
                                 fields::find_reconstruction("trilinear"));
  const WorldRay ray{Vec3(-1, 3.2, 3.3), Vec3(1, 0, 0)};
  EXPECT_TRUE(marched(field, 0.25, ray, {.steps_per_cell = 0.5}).empty());
  EXPECT_EQ(marched(field, 0.25, ray, {.steps_per_cell = 4}).size(), 2u);
}

TEST(UnitLevelMarch, StartsInsideTheVolumeAndEndsWhenTold) {
  const fields::LevelField field =
      nested([](const Vec3& x) { return x.x; }, fields::find_reconstruction("trilinear"));
  EXPECT_EQ(marched(field, 3, {Vec3(5, 4, 4), Vec3(1, 0, 0)}, {}).size(), 0u);
  EXPECT_EQ(marched(field, 3, {Vec3(2.5, 4, 4), Vec3(1, 0, 0)}, {}).size(), 1u);
  EXPECT_EQ(marched(field, 3, {Vec3(-1, 9, 4), Vec3(1, 0, 0)}, {}).size(), 0u);  // passes by
  const fields::LevelField waves(
      {sampled(Vec3(0), 0.125, 65, [](const Vec3& x) { return sin(4 * x.x); })},
      fields::find_reconstruction("trilinear"));
  int seen = 0;
  LevelMarch(waves, 0.5, {}).visit_crossings({Vec3(-1, 4, 4), Vec3(1, 0, 0)}, [&](double) {
    return ++seen < 3;
  });
  EXPECT_EQ(seen, 3);
}

}  // namespace
}  // namespace pellucid::groundtruth
