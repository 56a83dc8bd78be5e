// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/paths/seed_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/error.h"
#include "integrators/paths/seed_place.h"

namespace pellucid::integrators {
namespace {

void expect_tangent_is_derivative(const SeedCurve& curve) {
  for (double s = 0.013; s < 1; s += 0.0417) {
    constexpr double h = 1e-6;
    const Vec3 slope = (curve.point_at(s + h) - curve.point_at(s - h)) / (2 * h);
    // Differences of numbers of size 1 over 1e-6, and the cubic term.
    EXPECT_LE(glm::distance(curve.tangent_at(s), slope), 1e-7) << s;
  }
}

const Vec3 corners[] = {{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {1, 2, 3}};

TEST(UnitSeedCurve, PolylineGoesByArcLength) {
  const SeedCurve curve = polyline_seed(corners);
  EXPECT_EQ(curve.point_at(0), corners[0]);
  EXPECT_EQ(curve.point_at(1), corners[3]);
  // Lengths of 1, 2 and 3, and their sum, are exact; a share of a piece rounds once or twice.
  EXPECT_LE(glm::distance(curve.point_at(0.5), corners[2]), 1e-15);
  ASSERT_EQ(curve.corners.size(), 2u);
  EXPECT_NEAR(curve.corners[0], 1. / 6, 1e-15);
  EXPECT_NEAR(curve.corners[1], 3. / 6, 1e-15);
  expect_tangent_is_derivative(curve);
}

TEST(UnitSeedCurve, ClosedCurvesEndWhereTheyBegin) {
  for (const SeedCurve& curve : {polyline_seed(corners, true), spline_seed(corners, true),
                                 circle_seed({1, 2, 3}, {0, 1, 1}, 2)}) {
    EXPECT_TRUE(curve.closed);
    // cos 2π and sin 2π are off by 2.4e-16, times a radius of 2; coordinates up to 5 have an ulp of
    // 8.9e-16.
    EXPECT_LE(glm::distance(curve.point_at(0), curve.point_at(1)), 1e-14);
  }
}

TEST(UnitSeedCurve, CircleLiesInItsPlane) {
  const Vec3 center(1, 2, 3), normal(1, -1, 2);
  const SeedCurve curve = circle_seed(center, normal, 0.5);
  for (double s = 0; s < 1; s += 0.1) {
    // Coordinates up to 3.5 round by 2.2e-16 each, and the normal, √6 long, makes that 1.6e-15 if
    // all three add up.
    EXPECT_NEAR(glm::distance(curve.point_at(s), center), 0.5, 1e-15);
    EXPECT_NEAR(glm::dot(curve.point_at(s) - center, normal), 0, 2e-15);
  }
  expect_tangent_is_derivative(curve);
}

TEST(UnitSeedCurve, SplineGoesThroughItsPointsSmoothly) {
  for (const bool closed : {false, true}) {
    const SeedCurve curve = spline_seed(corners, closed);
    for (const Vec3& corner : corners) {
      double nearest = 1;
      for (int i = 0; i <= 100000; ++i)
        nearest = std::min(nearest, glm::distance(curve.point_at(i / 100000.), corner));
      EXPECT_LE(nearest, 1e-4);  // a step of the scan is 1e-5 of a length of about ten
    }
    expect_tangent_is_derivative(curve);
  }
}

TEST(UnitSeedCurve, CallableDifferencesItsTangent) {
  const auto helix = [](double s) { return Vec3(std::cos(s), std::sin(3 * s), s); };
  expect_tangent_is_derivative(callable_seed(helix));
}

TEST(UnitSeedCurve, RepeatedPointsAreDropped) {
  const Vec3 points[] = {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 0, 0}};
  EXPECT_TRUE(polyline_seed(points).corners.empty());
}

TEST(UnitSeedCurve, CornersAreWhereTheTangentTurns) {
  // A square with a point on its first side, and begun at a corner or in that side's middle.
  const Vec3 begun_at_corner[] = {{0, 0, 0}, {0.5, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const Vec3 begun_in_side[] = {{0.5, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}};
  EXPECT_EQ(polyline_seed(begun_at_corner, true).corners, (std::vector<double>{0, .25, .5, .75}));
  EXPECT_EQ(polyline_seed(begun_in_side, true).corners,
            (std::vector<double>{.125, .375, .625, .875}));
  EXPECT_EQ(polyline_seed(begun_at_corner).corners.size(), 2u);  // its ends are none
}

TEST(UnitSeedCurve, TheSeamIsAtBothEndsOfS) {
  const Vec3 triangle[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const SeedCurve closed = polyline_seed(triangle, true), open = polyline_seed(triangle);
  for (const double s : {0., 1e-10, 1 - 1e-10, 1., 1 + 1e-10, 2.}) {
    EXPECT_TRUE(is_corner(closed, s)) << s;
    EXPECT_FALSE(is_corner(open, s)) << s;
  }
  for (const double s : {1e-8, 0.1, 1 - 1e-8, 1.1}) EXPECT_FALSE(is_corner(closed, s)) << s;
}

TEST(UnitSeedCurve, CurvesOfNoLengthAreRefused) {
  const Vec3 same[] = {{1, 1, 1}, {1, 1, 1}};
  const Vec3 bad[] = {{1, 1, 1}, {1, std::numeric_limits<double>::quiet_NaN(), 1}};
  EXPECT_THROW(polyline_seed(same), InputError);
  EXPECT_THROW(polyline_seed(bad), InputError);
  EXPECT_THROW(circle_seed({0, 0, 0}, {0, 0, 0}, 1), InputError);
  EXPECT_THROW(circle_seed({0, 0, 0}, {0, 0, 1}, 0), InputError);
}

}  // namespace
}  // namespace pellucid::integrators
