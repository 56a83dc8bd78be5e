// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/levels/ray_polynomial.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "fields/levels/level_field.h"

namespace pellucid::groundtruth {
namespace {

class PropertyRayPolynomial : public ::testing::Test {
 protected:
  double any() { return number_(random_); }
  RayPolynomial any_line() { return {any(), any()}; }

  std::mt19937 random_{5};
  std::uniform_real_distribution<double> number_{-1, 1};
};

double between(const RayPolynomial& line, double t) {
  return (1 - t) * line.begin() + t * line.end();
}

TEST_F(PropertyRayPolynomial, OfATrilinearFormHasTheFormsValues) {
  for (int n = 0; n < 200; ++n) {
    const std::array<RayPolynomial, 3> lines{any_line(), any_line(), any_line()};
    std::array<double, 8> corners;
    for (double& corner : corners) corner = any();
    const RayPolynomial p = trilinear_form(lines, corners);
    for (const double t : {0.0, 0.1, 0.5, 0.77, 1.0}) {
      const std::array<double, 3> at{between(lines[0], t), between(lines[1], t),
                                     between(lines[2], t)};
      // Up to 2³ of numbers up to 1 on coordinates up to 1, in some ten roundings of 1.1e-16.
      EXPECT_NEAR(p(t), fields::trilinear_form(at, corners), 1e-14) << t;
    }
  }
}

TEST_F(PropertyRayPolynomial, OfALatticeCoordinateHasThatOfItsEnds) {
  for (int n = 0; n < 100; ++n) {
    const RayPolynomial line = any_line();
    const double origin = any(), width = 0.1 + std::abs(any());
    const RayPolynomial lattice = lattice_coordinate(line, origin, width, 3);
    EXPECT_EQ(lattice.begin(), fields::lattice_coordinate(line.begin(), origin, width, 3));
    EXPECT_EQ(lattice.end(), fields::lattice_coordinate(line.end(), origin, width, 3));
  }
}

TEST_F(PropertyRayPolynomial, SumsAndProductsOfAnyDegreesHaveTheirValues) {
  for (int n = 0; n < 100; ++n) {
    const RayPolynomial constant(any()), line = any_line(), square = any_line() * any_line();
    for (const double t : {0.0, 0.3, 1.0})
      for (const RayPolynomial* p : {&constant, &line, &square})
        for (const RayPolynomial* q : {&constant, &line, &square}) {
          EXPECT_NEAR((*p + *q)(t), (*p)(t) + (*q)(t), 1e-15);
          EXPECT_NEAR((*p * *q)(t), (*p)(t) * (*q)(t), 1e-15);
        }
  }
}

}  // namespace
}  // namespace pellucid::groundtruth
