// SPDX-License-Identifier: GPL-3.0-or-later
// Levels of samples: derived scalars, the region tree and the reconstructions.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/error.h"
#include "fields/levels/derived_scalar.h"
#include "fields/levels/level_field.h"
#include "fields/levels/surface_cells.h"
#include "tests/support/levels.h"

namespace pellucid::fields {
namespace {

using testing::nested;
using testing::sampled;

double abc_q(const Vec3& p) {
  // Without divergence Q = -tr(J²)/2. A = B = C = 1.
  return -(std::cos(p.x) * -std::sin(p.y) + std::cos(p.y) * -std::sin(p.z) +
           std::cos(p.z) * -std::sin(p.x));
}

Vec3 abc(const Vec3& p) {
  return {std::sin(p.z) + std::cos(p.y), std::sin(p.x) + std::cos(p.z),
          std::sin(p.y) + std::cos(p.x)};
}

double largest_error_of_q(int n) {
  const double width = 2.0 / n;
  const ScalarLevel q =
      find_derived_scalar("q").compute(sampled<glm::vec3>(Vec3(0.3), width, {n, n, n}, abc));
  double largest = 0;
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        largest = std::max(largest, std::abs(q.at(i, j, k) - abc_q(q.world(Vec3(i, j, k)))));
  return largest;
}

TEST(UnitDerivedScalar, QConvergesAtOrderTwoUpToTheFaces) {
  // Faces included: no shell of false values. The order of the one-sided difference, whose next
  // term is of order 3, shows within 0.25 here.
  const double order = std::log2(largest_error_of_q(16) / largest_error_of_q(32));
  EXPECT_NEAR(order, 2, 0.25);
  EXPECT_LT(largest_error_of_q(32), 0.02);
}

TEST(UnitDerivedScalar, OfALinearFlowIsExact) {
  const auto rotation = sampled<glm::vec3>(
      Vec3(-1), 0.5, {4, 5, 3}, [](const Vec3& x) { return Vec3(-3 * x.y, 3 * x.x, 1); });
  for (const float q : find_derived_scalar("q").compute(rotation).samples)
    EXPECT_NEAR(q, 9, 1e-5);  // samples are floats of size 3
  const auto& speed = find_derived_scalar("magnitude").compute(rotation);
  EXPECT_NEAR(speed.at(0, 0, 0), std::sqrt(9 + 9 + 1), 1e-6);
}

TEST(UnitDerivedScalar, UnknownNamesAreRefused) {
  EXPECT_THROW(find_derived_scalar("vorticity"), InputError);
}

TEST(UnitRegionTree, EveryPointFindsTheBoxesThatHoldIt) {
  const auto box = [](double x, double y, double z, double side) {
    return Box3{Vec3(x, y, z), Vec3(x, y, z) + side};
  };
  // Overlapping, disjoint, nested and identical.
  const std::vector<LevelRegion> regions{{box(0, 0, 0, 2), {}},
                                         {box(1, 0.5, 1, 3), box(1.5, 1, 1.5, 2)},
                                         {box(8, 8, 8, 1), {}},
                                         {box(1, 0.5, 1, 3), {}},
                                         {box(-1, -1, -1, 6), {}}};
  const RegionTree tree(regions);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-2, 10);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 x(uniform(random), uniform(random), uniform(random));
    std::vector<std::uint32_t> expected;
    for (std::uint32_t level = 0; level < regions.size(); ++level) {
      if (!regions[level].support.contains(x)) continue;
      expected.push_back(level);
      if (regions[level].alone.contains(x)) break;
    }
    const auto found = tree.levels_at(x);
    // Beyond all boxes the nearest leaf answers: its caller tests.
    if (expected.empty()) continue;
    EXPECT_EQ(std::vector(found.begin(), found.end()), expected);
  }
  EXPECT_EQ(tree.most_levels(), 4u);
}

class PropertyReconstruction : public ::testing::TestWithParam<ReconstructionRow> {};
INSTANTIATE_TEST_SUITE_P(All, PropertyReconstruction, ::testing::ValuesIn(reconstructions),
                         [](const auto& row) { return std::string(row.param.name); });

TEST_P(PropertyReconstruction, KeepsConstants) {
  const LevelField field(nested([](const Vec3&) { return 0.75; }), GetParam());
  for (double x = 0.6; x < 7.4; x += 0.17) {
    // Weights of eight samples, whose sum is 1 up to a few roundings of 1.1e-16; a derivative is a
    // difference of them over half a cell's width.
    EXPECT_NEAR(field.value(Vec3(x, 3.9, 4.1)).value(), 0.75, 1e-15);
    EXPECT_LT(glm::length(field.gradient(Vec3(x, 3.9, 4.1)).value()), 1e-14);
  }
}

TEST_P(PropertyReconstruction, KeepsLinearFunctionsAcrossAJumpIfItSaysSo) {
  const LevelField field(nested([](const Vec3& x) { return x.x; }), GetParam());
  double largest = 0;
  for (double x = 0.6; x < 7.4; x += 0.01)
    largest = std::max(largest, std::abs(field.value(Vec3(x, 3.9, 4.1)).value() - x));
  // Samples are sums of powers of two: exact in float. Where it does not keep them, the hat basis
  // errs by a fraction of a fine cell of 0.5.
  if (GetParam().linear_preserving) {
    EXPECT_LT(largest, 1e-14);
  } else {
    EXPECT_GT(largest, 0.05);
  }
}

TEST_P(PropertyReconstruction, IsContinuousAcrossAJumpIfItSaysSo) {
  const LevelField field(nested([](const Vec3& x) { return std::sin(3 * x.x + x.y * x.z); }),
                         GetParam());
  double largest = 0;
  for (double y = 1.03; y < 7; y += 0.1) {
    for (double x = 0.6; x < 7.4; x += 0.125 / 64)
      largest = std::max(largest, std::abs(field.value(Vec3(x + 0.125 / 64, y, 4.1)).value() -
                                           field.value(Vec3(x, y, 4.1)).value()));
  }
  // Slopes of at most 2 per fine cell, some times that where weights change too.
  if (GetParam().continuous) {
    EXPECT_LT(largest, 0.04);
  } else {
    EXPECT_GT(largest, 0.1);
  }
}

TEST_P(PropertyReconstruction, GradientIsThatOfTheValue) {
  const LevelField field(nested([](const Vec3& x) { return x.x * x.y - x.z * x.z; }), GetParam());
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0.7, 7.3);
  constexpr double h = 1e-6;
  for (int i = 0; i < 200; ++i) {
    const Vec3 x(uniform(random), uniform(random), uniform(random));
    const Vec3 gradient = field.gradient(x).value();
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 step(0);
      step[axis] = h;
      // Rounding: 64 ulp / h; the third derivative's share is less.
      EXPECT_NEAR((*field.value(x + step) - *field.value(x - step)) / (2 * h), gradient[axis],
                  2e-7);
    }
  }
}

TEST_P(PropertyReconstruction, CellsOfTheSurfaceHoldEveryPlaceOfItsValue) {
  const LevelField field(nested([](const Vec3& x) { return glm::length(x - Vec3(4.3, 4, 4)); }),
                         GetParam());
  constexpr double value = 2.1;  // through the jump
  const auto cells = surface_cells(field, value);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0.7, 7.3);
  int found = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 x(uniform(random), uniform(random), uniform(random));
    if (std::abs(field.value(x).value() - value) > 1e-3) continue;
    ++found;
    EXPECT_TRUE(std::ranges::any_of(
        cells, [&](const LatticeCell& cell) { return cell_box(field, cell).contains(x); }));
  }
  EXPECT_GT(found, 5);
}

TEST_P(PropertyReconstruction, OutsideThereIsNoValue) {
  const LevelField field(nested([](const Vec3&) { return 1.0; }), GetParam());
  EXPECT_FALSE(field.value(Vec3(-0.6, 4, 4)));
  EXPECT_FALSE(field.value(Vec3(4, 4, 8.4)));
  EXPECT_FALSE(field.gradient(Vec3(1e30)));
}

TEST_P(PropertyReconstruction, IdenticalAndDisjointLevelsAreWhatTheyAreAlone) {
  const auto f = [](const Vec3& x) { return x.x * x.y; };
  const ScalarLevel level = sampled<float>(Vec3(0), 1, {4, 4, 4}, f);
  const ScalarLevel far = sampled<float>(Vec3(100), 2, {3, 3, 3}, f);
  const LevelField alone({level}, GetParam()), all({level, far, level}, GetParam());
  for (double x = 0.1; x < 3; x += 0.1)
    // Values up to 9, of twice the terms: an ulp is 1.8e-15.
    EXPECT_NEAR(*all.value(Vec3(x, 1.3, 2.7)), *alone.value(Vec3(x, 1.3, 2.7)), 1e-14);
  EXPECT_TRUE(all.value(Vec3(102)));
  EXPECT_FALSE(all.value(Vec3(50)));
}

TEST_P(PropertyReconstruction, ACoarserLevelWithinItsParentChangesNothing) {
  // Where levels overlap the finest rules, wherever the coarser one lies.
  const auto f = [](const Vec3& x) { return x.x * x.y - x.z; };
  const ScalarLevel parent = sampled<float>(Vec3(0), 0.5, {17, 17, 17}, f);
  const ScalarLevel within = sampled<float>(Vec3(3), 1, {3, 3, 3}, [](const Vec3&) { return 99; });
  const LevelField alone({parent}, GetParam()), both({within, parent}, GetParam());
  for (double x = 0.1; x < 8; x += 0.1)
    EXPECT_EQ(*both.value(Vec3(x, 3.8, 4.2)), *alone.value(Vec3(x, 3.8, 4.2)));
  const auto cells = surface_cells(both, 2);
  EXPECT_EQ(cells.size(), surface_cells(alone, 2).size());
}

TEST(UnitLevelField, TheHatBasisErrsByTheKnownFractionAtAJump) {
  // Along the middle of a face at x = 2: coarse samples at 1.5, fine ones at 2.25. At x = 2 the
  // coarse hat is 1/2 and the fine one 1/2; across the face both kinds sum to 1. So the value is
  // (1.5 + 2.25)/2 = 1.875 where f(x) = x is 2: a quarter of a fine cell.
  const LevelField field(nested([](const Vec3& x) { return x.x; }), find_reconstruction("hat"));
  EXPECT_NEAR(field.value(Vec3(2, 4, 4)).value(), 1.875, 1e-15);
}

/// Σ h f / Σ h over all samples that no finer level covers, each with a hat as wide as its cells:
/// Li, Chen 2023, Eqs. 2 and 3, sample by sample.
std::optional<double> by_hats_of_all(const std::vector<ScalarLevel>& finest_first, const Vec3& x) {
  double sum = 0, weight = 0;
  const auto is_covered = [&](std::size_t level, const Vec3& sample) {
    return std::any_of(finest_first.begin(), finest_first.begin() + std::ptrdiff_t(level),
                       [&](const ScalarLevel& finer) { return finer.box(0.5).contains(sample); });
  };
  for (std::size_t l = 0; l < finest_first.size(); ++l) {
    const ScalarLevel& level = finest_first[l];
    for (int k = 0; k < level.size[2]; ++k)
      for (int j = 0; j < level.size[1]; ++j)
        for (int i = 0; i < level.size[0]; ++i) {
          const Vec3 sample = level.world(Vec3(i, j, k));
          const Vec3 h = glm::max(Vec3(0), 1.0 - glm::abs(x - sample) / level.width);
          if (is_covered(l, sample)) continue;
          weight += h.x * h.y * h.z;
          sum += h.x * h.y * h.z * level.at(i, j, k);
        }
  }
  return weight > 0 ? std::optional(sum / weight) : std::nullopt;
}

TEST(PropertyLevelField, TheHatBasisIsThatOfAllUncoveredSamples) {
  auto levels = nested([](const Vec3& x) { return std::sin(3 * x.x + x.y * x.z); });
  const LevelField field(levels, find_reconstruction("hat"));
  std::swap(levels[0], levels[1]);  // the finest first
  std::mt19937 random(11);
  std::uniform_real_distribution<double> anywhere(0.01, 7.99);
  for (int n = 0; n < 2000; ++n) {
    const Vec3 x(anywhere(random), anywhere(random), anywhere(random));
    // Of samples up to 1, some 16 of which have a weight.
    EXPECT_NEAR(field.value(x).value(), by_hats_of_all(levels, x).value(), 1e-14) << n;
  }
}

TEST(UnitLevelField, BadLevelsAreRefused) {
  const auto& blend = find_reconstruction("blend");
  const auto zero = [](const Vec3&) { return 0.0; };
  EXPECT_THROW(LevelField({}, blend), InputError);
  EXPECT_THROW(LevelField({sampled<float>(Vec3(0), 1, {1, 1, 1}, zero)}, blend), InputError);
  EXPECT_THROW(LevelField({sampled<float>(Vec3(0), -1, {4, 4, 4}, zero)}, blend), InputError);
  EXPECT_THROW(LevelField({sampled<float>(Vec3(NAN), 1, {4, 4, 4}, zero)}, blend), InputError);
  auto level = sampled<float>(Vec3(0), 1, {4, 4, 4}, zero);
  level.samples[7] = NAN;
  EXPECT_THROW(LevelField({level}, blend), InputError);
  level.samples.pop_back();
  EXPECT_THROW(LevelField({level}, blend), InputError);
  const std::vector six(6, sampled<float>(Vec3(0), 1, {4, 4, 4}, zero));
  EXPECT_THROW(LevelField(six, blend), InputError);
  EXPECT_THROW(find_reconstruction("spline"), InputError);
}

}  // namespace
}  // namespace pellucid::fields
