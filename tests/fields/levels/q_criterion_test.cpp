// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/levels/q_criterion.h"

#include <gtest/gtest.h>

#include <random>

namespace pellucid::fields {
namespace {

template <class T>
Level<glm::vec<3, T>> random_level(const std::array<int, 3>& size) {
  Level<glm::vec<3, T>> level{Vec3(1, 2, 3), 0.3, size, {}};
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int i = 0; i < size[0] * size[1] * size[2]; ++i)
    level.samples.emplace_back(T(any(random)), T(any(random)), T(any(random)));
  return level;
}

/// The derivative along an axis, times the cell's width, sample by sample.
template <class T>
Vec3 difference(const Level<glm::vec<3, T>>& level, std::array<int, 3> at, std::size_t axis) {
  const auto f = [&](int step) {
    std::array<int, 3> there = at;
    there[axis] += step;
    return Vec3(level.at(there[0], there[1], there[2]));
  };
  if (at[axis] == 0) return 0.5 * (-3.0 * f(0) + 4.0 * f(1) - f(2));
  if (at[axis] == level.size[axis] - 1) return 0.5 * (3.0 * f(0) - 4.0 * f(-1) + f(-2));
  return 0.5 * (f(1) - f(-1));
}

template <class T>
void expect_sample_by_sample(const std::array<int, 3>& size) {
  const auto level = random_level<T>(size);
  const Level<T> q = q_criterion(level);
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i) {
        const Vec3 x = difference(level, {i, j, k}, 0), y = difference(level, {i, j, k}, 1),
                   z = difference(level, {i, j, k}, 2);
        const double sum =
            -0.5 * (x.x * x.x + y.y * y.y + z.z * z.z) - y.x * x.y - z.x * x.z - z.y * y.z;
        ASSERT_EQ(q.at(i, j, k), T(1 / (level.width * level.width) * sum))
            << i << " " << j << " " << k;
      }
}

// Rows shorter than any vector, and longer ones that no width divides; a level has three samples at
// least.
TEST(PropertyQCriterion, RowsAreWhatTheirSamplesAre) {
  for (const std::array<int, 3>& size :
       {std::array{3, 3, 3}, {4, 3, 5}, {5, 4, 3}, {17, 6, 7}, {64, 3, 3}}) {
    expect_sample_by_sample<float>(size);
    expect_sample_by_sample<double>(size);
  }
}

}  // namespace
}  // namespace pellucid::fields
