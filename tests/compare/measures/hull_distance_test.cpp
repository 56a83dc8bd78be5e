// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/measures/hull_distance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/common.hpp>
#include <random>
#include <vector>

namespace pellucid::compare {
namespace {

/// The search ends where a squared distance can lessen by 1e-14 at most: at the hull itself that is
/// a distance of 1e-7. Elsewhere it is found to some 1e-16.
constexpr double projection = 1e-7;

const std::vector<Vec3> tetrahedron{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

TEST(UnitHullDistance, OfATetrahedronIsThatToItsCornerEdgeOrFace) {
  EXPECT_EQ(hull_distance({0.25, 0.25, 0.25}, tetrahedron), 0);
  EXPECT_NEAR(hull_distance({-1, -2, -2}, tetrahedron), 3, projection);
  EXPECT_NEAR(hull_distance({0.5, -3, -4}, tetrahedron), 5, projection);
  EXPECT_NEAR(hull_distance({0.2, 0.2, -0.5}, tetrahedron), 0.5, projection);
  EXPECT_NEAR(hull_distance({1, 1, 1}, tetrahedron), 2 / std::sqrt(3.0), projection);
}

TEST(UnitHullDistance, OfFlatHulls) {
  const std::vector<Vec3> one{{0.5, 0.5, 0.5}};
  EXPECT_NEAR(hull_distance({0.5, 0.5, 0.75}, one), 0.25, projection);
  const std::vector<Vec3> same(5, Vec3(0.5));
  EXPECT_NEAR(hull_distance({0.5, 0.5, 0.75}, same), 0.25, projection);
  const std::vector<Vec3> greys{{0, 0, 0}, {0.5, 0.5, 0.5}, {1, 1, 1}, {0.75, 0.75, 0.75}};
  EXPECT_NEAR(hull_distance(Vec3(0.3), greys), 0, projection);
  EXPECT_NEAR(hull_distance(Vec3(1.5), greys), std::sqrt(0.75), projection);
}

// The cube's corners, with and without points inside: the distance to a box is known.
TEST(UnitHullDistance, OfACubeOfManyPoints) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> inside(0, 1), around(-1, 2);
  std::vector<Vec3> points;
  for (int corner = 0; corner < 8; ++corner)
    points.emplace_back(corner & 1, corner >> 1 & 1, corner >> 2);
  for (int i = 0; i < 40; ++i) points.emplace_back(inside(random), inside(random), inside(random));
  for (int i = 0; i < 500; ++i) {
    const Vec3 p(around(random), around(random), around(random));
    const double expected = glm::length(p - glm::clamp(p, Vec3(0), Vec3(1)));
    EXPECT_NEAR(hull_distance(p, points), expected, projection) << p.x << ' ' << p.y << ' ' << p.z;
  }
}

}  // namespace
}  // namespace pellucid::compare
