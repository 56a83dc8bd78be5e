// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/sampled/linear_cells.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

namespace pellucid::fields {
namespace {

constexpr double rounding = 1e-13;  // some operations on numbers up to 4

Vec3 anywhere(std::mt19937& random, double low, double high) {
  std::uniform_real_distribution<double> any(low, high);
  return {any(random), any(random), any(random)};
}

template <std::size_t N>
std::array<Vec3, N> arms(const std::array<Vec3, N>& corners, const Vec3& x) {
  std::array<Vec3, N> arms;
  for (std::size_t i = 0; i < N; ++i) arms[i] = corners[i] - x;
  return arms;
}

template <std::size_t N>
Vec3 weighted(const std::array<double, N>& weights, const std::array<Vec3, N>& corners) {
  Vec3 sum(0);
  for (std::size_t i = 0; i < N; ++i) sum += weights[i] * corners[i];
  return sum;
}

/// A place within, and one beyond a face, whichever way round the corners are.
TEST(PropertyLinearCells, WhatIsInATetrahedronIsToldFromWhatIsNot) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(0.01, 1);
  int fat = 0;
  for (int run = 0; run < 2000; ++run) {
    std::array<Vec3, 4> corners;
    for (Vec3& corner : corners) corner = anywhere(random, -1, 1);
    if (std::abs(glm::determinant(
            Mat3(corners[1] - corners[0], corners[2] - corners[0], corners[3] - corners[0]))) < 0.1)
      continue;
    std::array<double, 4> weights{any(random), any(random), any(random), any(random)};
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.);
    for (double& weight : weights) weight /= sum;
    EXPECT_TRUE(is_in_tetrahedron(arms(corners, weighted(weights, corners))));
    const double beyond = weights[std::size_t(run) % 4] + 1e-6;  // the face across that corner
    weights[std::size_t(run) % 4] -= beyond;
    weights[std::size_t(run + 1) % 4] += beyond;
    EXPECT_FALSE(is_in_tetrahedron(arms(corners, weighted(weights, corners))));
    ++fat;
  }
  EXPECT_GT(fat, 500);
}

TEST(UnitLinearCells, CornersAreInATetrahedronAndAFlatOneHoldsNothing) {
  const std::array<Vec3, 4> corners{Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
  for (const Vec3& corner : corners) EXPECT_TRUE(is_in_tetrahedron(arms(corners, corner)));
  const std::array<Vec3, 4> flat{Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(1, 1, 0)};
  EXPECT_FALSE(is_in_tetrahedron(arms(flat, Vec3(0.2, 0.2, 0))));
}

std::array<Vec3, 8> bent_cube(std::mt19937& random, double bend) {
  std::array<Vec3, 8> corners{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0),
                              Vec3(0, 0, 1), Vec3(1, 0, 1), Vec3(1, 1, 1), Vec3(0, 1, 1)};
  for (Vec3& corner : corners) corner += anywhere(random, -bend, bend);
  return corners;
}

TEST(PropertyLinearCells, APlaceInAHexahedronIsFound) {
  std::mt19937 random(2);
  for (int run = 0; run < 2000; ++run) {
    const std::array<Vec3, 8> corners = bent_cube(random, 0.2);
    const Vec3 p = anywhere(random, 0.001, 0.999);
    Vec3 found;
    ASSERT_EQ(place_in_hexahedron(arms(corners, weighted(hexahedron_weights(p), corners)), found),
              Side::inside);
    EXPECT_LE(glm::length(found - p), 100 * rounding);
    Vec3 beyond = p;
    beyond[run % 3] = run % 2 ? 1.01 : -0.01;
    EXPECT_EQ(
        place_in_hexahedron(arms(corners, weighted(hexahedron_weights(beyond), corners)), found),
        Side::outside);
  }
}

TEST(PropertyLinearCells, SlopesAreThoseOfTheWeights) {
  std::mt19937 random(3);
  constexpr double step = 1e-3;  // of functions that are linear along each axis
  for (int run = 0; run < 100; ++run) {
    const Vec3 p = anywhere(random, 0, 1);
    const auto slopes = hexahedron_slopes(p);
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 ahead = p, behind = p;
      ahead[axis] += step, behind[axis] -= step;
      const auto above = hexahedron_weights(ahead), below = hexahedron_weights(behind);
      for (std::size_t i = 0; i < 8; ++i)
        EXPECT_NEAR(slopes[i][axis], (above[i] - below[i]) / (2 * step), rounding / step);
    }
  }
}

/// A face that has collapsed to an edge, and a cell without any volume: Newton's steps have no end.
TEST(UnitLinearCells, WhatNewtonCannotSolveIsUnsure) {
  std::array<Vec3, 8> flat;
  for (std::size_t i = 0; i < 8; ++i) flat[i] = Vec3(i % 2, i / 2 % 2, 0);
  Vec3 found;
  EXPECT_EQ(place_in_hexahedron(arms(flat, Vec3(0.3, 0.4, 0)), found), Side::unsure);
}

}  // namespace
}  // namespace pellucid::fields
