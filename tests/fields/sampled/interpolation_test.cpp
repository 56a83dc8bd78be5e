// SPDX-License-Identifier: GPL-3.0-or-later
// The two samplers: what they reproduce, how smooth they are, how fast they converge, and whether
// the reported sampling error is the true one.

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "fields/make_field.h"
#include "tests/fields/probe.h"
#include "tests/fields/readers/grid_files.h"

namespace pellucid::fields {
namespace {

Vec3 wave(const Vec3& x) {
  return {std::sin(3 * x.x) * std::cos(2 * x.y), std::cos(4 * x.z + x.x), std::sin(2 * x.y * x.z)};
}

class AgreementSamplers : public ::testing::Test {
 protected:
  std::unique_ptr<VectorField> cube(int count, const std::string& sampler,
                                    const Velocity& velocity = wave) {
    const auto path = folder_ / "cube.vti";
    write_cube(path, count, velocity);
    return make_field(path.string() + ":sampler=" + sampler);
  }

  static double largest_error(const VectorField& field, const Velocity& velocity = wave) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> fraction(0, 1);
    const auto sampler = field.sampler();
    double largest = 0;
    for (int i = 0; i < 20000; ++i) {
      const Vec3 x(fraction(random), fraction(random), fraction(random));
      Vec3 v;
      EXPECT_EQ(sampler->velocity(x, 0, v), SampleStatus::ok);
      largest = std::max(largest, glm::length(v - velocity(x)));
    }
    return largest;
  }

  double observed_order(const std::string& sampler) {
    return std::log2(largest_error(*cube(17, sampler)) / largest_error(*cube(33, sampler)));
  }

  TemporaryFolder folder_;
};

TEST_F(AgreementSamplers, LinearIsOfSecondOrder) { EXPECT_NEAR(observed_order("linear"), 2, 0.15); }

// The one-sided slopes at the edges are of the same order as the central ones.
TEST_F(AgreementSamplers, C1IsOfThirdOrder) { EXPECT_NEAR(observed_order("c1"), 3, 0.25); }

TEST_F(AgreementSamplers, C1ReproducesParabolas) {
  const Velocity parabola = [](const Vec3& x) {
    return Vec3(x.x * x.x, x.y * x.y - x.x * x.z, x.z * x.z * x.y);
  };
  // 64 products of values up to 1: some 100 roundings of 1.1e-16 if they all add up, ten times less
  // if not.
  EXPECT_LE(largest_error(*cube(6, "c1", parabola), parabola), 1.1e-14);
  EXPECT_GE(largest_error(*cube(6, "linear", parabola), parabola), 1e-3);
}

TEST_F(AgreementSamplers, C1ReproducesParabolasOnUnevenAxes) {
  const Velocity parabola = [](const Vec3& x) { return Vec3(x.x * x.x, x.y * x.y, x.z * x.z); };
  const auto field =
      make_field(write_grid(folder_, grid_kind("vtr"), parabola).string() + ":sampler=c1");
  for (const Vec3& x : {Vec3(0.1, -0.9, 1.2), Vec3(1, 0.3, 2.9), Vec3(1.9, 0.95, 3.8)})
    EXPECT_NEAR_VEC(velocity_of(*field, x), parabola(x), 1e-13);
}

/// How far the Jacobians on either side of the faces of cells differ.
double jump_of_jacobian(const VectorField& field, int count) {
  const auto sampler = field.sampler();
  double largest = 0;
  for (int i = 1; i + 1 < count; ++i) {
    const double face = double(i) / (count - 1);
    Vec3 v;
    Mat3 before, behind;
    sampler->velocity_and_jacobian({face - 1e-9, 0.37, 0.61}, 0, v, before);
    sampler->velocity_and_jacobian({face + 1e-9, 0.37, 0.61}, 0, v, behind);
    largest = std::max(largest, norm(behind - before));
  }
  return largest;
}

TEST_F(AgreementSamplers, C1HasNoKinks) {
  EXPECT_LE(jump_of_jacobian(*cube(9, "c1"), 9), 1e-6);  // 2e-9 times the second derivative
  EXPECT_GE(jump_of_jacobian(*cube(9, "linear"), 9), 0.1);
}

TEST_F(AgreementSamplers, TheJacobianOfC1IsItsOwn) {
  const auto field = cube(9, "c1");
  for (const Vec3& x : {Vec3(0.01, 0.52, 0.99), Vec3(0.33, 0.71, 0.42), Vec3(0.9, 0.05, 0.6)})
    expect_consistent_jacobian(*field, x, 0, 1e-6, 1e-8);
}

// The estimate takes derivatives from differences, and adds what the axes cause though their worst
// places differ: it may be twice the truth.
TEST_F(AgreementSamplers, TheReportedErrorIsTheMeasuredOne) {
  for (const std::string sampler : {"linear", "c1"}) {
    const auto field = cube(25, sampler);
    const double measured = largest_error(*field), reported = *field->sampling_error();
    EXPECT_GE(reported, 0.9 * measured) << sampler;
    EXPECT_LE(reported, 2.5 * measured) << sampler;
  }
}

TEST_F(AgreementSamplers, TheReportedErrorOfCellsIsNearTheMeasuredOne) {
  const auto grid = make_field(write_grid(folder_, grid_kind("vts"), wave).string());
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> fraction(0, 1);
  double measured = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 x = grid_box.min + (grid_box.max - grid_box.min) *
                                      Vec3(fraction(random), fraction(random), fraction(random));
    measured = std::max(measured, glm::length(velocity_of(*grid, x) - wave(x)));
  }
  // Coarse: 5 to 7 samples for a wave and more.
  EXPECT_GE(*grid->sampling_error(), 0.3 * measured);
  EXPECT_LE(*grid->sampling_error(), 3 * measured);
}

TEST_F(AgreementSamplers, SampledAbcIsWithinItsReportedErrorOfTheAnalytic) {
  const auto abc = make_field("abc");
  const Velocity velocity = [&](const Vec3& x) { return velocity_of(*abc, 6.0 * x); };
  for (const std::string sampler : {"linear", "c1"}) {
    const auto field = cube(40, sampler, velocity);
    EXPECT_LE(largest_error(*field, velocity), *field->sampling_error());
  }
}

}  // namespace
}  // namespace pellucid::fields
