// SPDX-License-Identifier: GPL-3.0-or-later
// What a linear flow makes of a vector, against closed forms.
#include "integrators/paths/linear_flow.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace pellucid::integrators {
namespace {

// Columns.
const Mat3 rotation({0, 1, 0}, {-1, 0, 0}, {0, 0, 0});
const Mat3 saddle({1, 0, 0}, {0, -2, 0}, {0, 0, 0.5});

TEST(UnitLinearFlow, RotationsAndSaddlesInClosedForm) {
  for (const double t : {0.0, 1e-9, 0.3, 7.0, -7.0}) {
    const Vec3 turned = carried_linearly(rotation, t, {1, 0, 2});
    // Some six squarings double the rounding of a length of √5 each time.
    EXPECT_LE(glm::distance(turned, Vec3(std::cos(t), std::sin(t), 2)), 1e-13) << t;
    const Vec3 wanted(std::exp(t), std::exp(-2 * t), std::exp(0.5 * t));
    const Vec3 stretched = carried_linearly(saddle, t, Vec3(1));
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(stretched[i] / wanted[i], 1, 1e-13) << t;
  }
}

TEST(UnitLinearFlow, AShearHasOneTermOnly) {
  const Mat3 shear({0, 0, 0}, {3, 0, 0}, {0, 0, 0});
  EXPECT_LE(glm::distance(carried_linearly(shear, 100, {1, 2, 3}), Vec3(601, 2, 3)), 1e-10);
}

TEST(PropertyLinearFlow, TwoTimesOneAfterTheOtherAreTheirSum) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int i = 0; i < 100; ++i) {
    Mat3 a;
    for (int column = 0; column < 3; ++column)
      for (int row = 0; row < 3; ++row) a[column][row] = any(random);
    const Vec3 w(any(random), any(random), any(random));
    const double s = 2 * any(random), t = 2 * any(random);
    const Vec3 whole = carried_linearly(a, s + t, w);
    const Vec3 parts = carried_linearly(a, s, carried_linearly(a, t, w));
    // Each exponential has a norm of e^6 at most, and rounds by some parts in 1e15 of it.
    EXPECT_LE(glm::distance(whole, parts), 1e-9);
  }
}

TEST(UnitLinearFlow, BeyondTheRangeOfADoubleTheDirectionStays) {
  const Vec3 stretched = carried_linearly(saddle, 1e6, Vec3(1));
  EXPECT_EQ(glm::normalize(stretched), Vec3(1, 0, 0));
  const Vec3 shrunk = carried_linearly(-Mat3(1), 1e6, {3, 0, 4});
  EXPECT_NEAR(glm::distance(glm::normalize(shrunk), Vec3(0.6, 0, 0.8)), 0, 1e-15);
  EXPECT_EQ(carried_linearly(Mat3(INFINITY), 1, Vec3(1, 2, 3)), Vec3(1, 2, 3));
  EXPECT_EQ(carried_linearly(Mat3(NAN), 1, Vec3(1, 2, 3)), Vec3(1, 2, 3));
}

}  // namespace
}  // namespace pellucid::integrators
