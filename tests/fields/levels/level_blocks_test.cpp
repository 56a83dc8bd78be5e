// SPDX-License-Identifier: GPL-3.0-or-later
// A lattice cut into blocks is what it is whole.
#include "fields/levels/level_blocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "fields/levels/derived_scalar.h"
#include "fields/levels/level_field.h"
#include "tests/support/levels.h"

namespace pellucid::fields {
namespace {

using testing::sampled;

double wavy(const Vec3& x) { return std::sin(1.3 * x.x) * std::cos(x.y) + 0.3 * x.z * x.x; }

/// Samples `first` … `first + size - 1` of a level.
template <class T>
Level<T> block(const Level<T>& whole, const std::array<int, 3>& first,
               const std::array<int, 3>& size) {
  Level<T> part{whole.world(Vec3(first[0], first[1], first[2])), whole.width, size, {}};
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i)
        part.samples.push_back(whole.at(first[0] + i, first[1] + j, first[2] + k));
  return part;
}

/// Cuts blocks in two, `shared` layers of samples in both, until there are n; none gets thinner
/// than three samples.
template <class T>
std::vector<Level<T>> cut_up(const Level<T>& whole, std::size_t n, int shared,
                             std::mt19937& random) {
  std::vector<Level<T>> blocks{whole};
  while (blocks.size() < n) {
    const std::size_t axis = random() % 3;
    const Level<T> old = blocks.front();
    blocks.erase(blocks.begin());
    const int samples = old.size[axis], room = samples + shared - 6;
    if (room < 0) {
      blocks.push_back(old);
      continue;
    }
    std::array<int, 3> low = old.size, high = old.size, first{};
    low[axis] = 3 + int(random() % unsigned(room + 1));
    first[axis] = low[axis] - shared;
    high[axis] = samples - first[axis];
    blocks.push_back(block(old, {0, 0, 0}, low));
    blocks.push_back(block(old, first, high));
  }
  std::ranges::shuffle(blocks, random);
  return blocks;
}

class PropertyBlocks : public ::testing::TestWithParam<ReconstructionRow> {};

TEST_P(PropertyBlocks, AreWhatTheLatticeIsWhole) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  for (const int shared : {0, 1, 2})
    for (std::size_t n = 2; n < 9; ++n) {
      const ScalarLevel whole = sampled(Vec3(0.1, -3, 7), 0.3, {17, 15, 14}, wavy);
      const LevelField one({whole}, GetParam()), many(cut_up(whole, n, shared, random), GetParam());
      const Box3 box = one.bounds();
      for (int i = 0; i < 300; ++i) {
        const Vec3 x =
            box.min + Vec3(unit(random), unit(random), unit(random)) * (box.max - box.min);
        ASSERT_TRUE(many.value(x)) << n << " blocks that share " << shared;
        // Lattice coordinates of blocks with origins of their own: 1e-15 of values up to 3, times
        // the slopes.
        EXPECT_NEAR(*many.value(x), *one.value(x), 1e-12) << n << ' ' << shared;
      }
    }
}

// Blocks like bricks in a wall: no two of the upper row meet where two of the lower do.
TEST_P(PropertyBlocks, ThatMakeNoBoxHaveNoCellsMissing) {
  const ScalarLevel whole = sampled(Vec3(0), 0.5, {12, 9, 8}, wavy);
  const std::vector<ScalarLevel> bricks{
      block(whole, {0, 0, 0}, {5, 4, 8}), block(whole, {5, 0, 0}, {7, 4, 8}),
      block(whole, {0, 4, 0}, {8, 5, 3}), block(whole, {0, 4, 3}, {8, 5, 5}),
      block(whole, {8, 4, 0}, {4, 5, 8})};
  const LevelField one({whole}, GetParam()), many(bricks, GetParam());
  std::mt19937 random(6);
  std::uniform_real_distribution<double> unit(0, 1);
  const Box3 box = one.bounds();
  for (int i = 0; i < 3000; ++i) {
    const Vec3 x = box.min + Vec3(unit(random), unit(random), unit(random)) * (box.max - box.min);
    ASSERT_TRUE(many.value(x)) << x.x << ' ' << x.y << ' ' << x.z;
    EXPECT_NEAR(*many.value(x), *one.value(x), 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(Reconstructions, PropertyBlocks, ::testing::ValuesIn(reconstructions),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(UnitBlocks, OnlyWhatGoesOnIsJoined) {
  const ScalarLevel whole = sampled(Vec3(0), 1, {9, 4, 4}, wavy);
  const ScalarLevel low = block(whole, {0, 0, 0}, {4, 4, 4}),
                    high = block(whole, {4, 0, 0}, {5, 4, 4});
  const auto count = [](std::vector<ScalarLevel> levels) { return joined_blocks(levels).size(); };
  ASSERT_EQ(count({high, low}), 1u);
  EXPECT_EQ(joined_blocks(std::vector<ScalarLevel>{high, low}).front().samples, whole.samples);
  ScalarLevel other = high;
  other.origin.x += 1;  // a cell is missing
  EXPECT_EQ(count({low, other}), 2u);
  other = high;
  other.origin.x += 0.1;  // another lattice
  EXPECT_EQ(count({low, other}), 2u);
  other = high;
  other.width = 2;
  EXPECT_EQ(count({low, other}), 2u);
  other = block(whole, {3, 0, 0}, {5, 4, 4});  // shares a layer
  EXPECT_EQ(count({low, other}), 1u);
  other.samples[0] += 1;  // … which says something else
  EXPECT_EQ(count({low, other}), 2u);
  EXPECT_EQ(count({whole, low}), 2u);  // within
  EXPECT_EQ(count({low, low, low}), 3u);
}

// Differences at the faces of blocks are central ones, too.
TEST(UnitBlocks, DerivedScalarsAreThoseOfTheWholeLattice) {
  const auto flow = [](const Vec3& x) { return glm::vec3(wavy(x), wavy(2.0 * x), x.y * x.y); };
  const VectorLevel whole = sampled<glm::vec3>(Vec3(0), 0.25, {12, 11, 10}, flow);
  std::mt19937 random(7);
  const auto parts = scalars_of(cut_up(whole, 6, 0, random), "q");
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts.front().samples, scalars_of(std::vector{whole}, "q").front().samples);
}

}  // namespace
}  // namespace pellucid::fields
