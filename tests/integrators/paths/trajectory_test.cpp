// SPDX-License-Identifier: GPL-3.0-or-later
// Steppers and single trajectories against closed forms.
#include "integrators/paths/trajectory.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/make_field.h"
#include "integrators/paths/counting_sampler.h"
#include "integrators/paths/trajectory_options.h"
#include "tests/integrators/test_fields.h"

namespace pellucid::integrators {
namespace {

using testing::boxed;
using testing::everywhere;
using testing::FunctionField;

const ButcherTableau& stepper(std::string_view name) {
  for (const ButcherTableau& row : steppers())
    if (row.name == name) return row;
  throw std::runtime_error("no such stepper");
}

TrajectoryOptions dopri5(double duration, double tolerance = 1e-9) {
  TrajectoryOptions options;
  options.stepper = &stepper("dopri5");
  options.duration = duration;
  options.tolerance = tolerance;
  return options;
}

// End points with an error below 1e-15, from an integration in extended precision.
const Vec3 abc_start(0.1, 0.2, 0.3);
const Vec3 abc_end_1(1.887611046492209, 1.911433906176317, 1.728439620240521);
const Vec3 abc_end_10(-4.100131563534621, 1.161312073414934, -2.922645438554284);

double error_at_1(const ButcherTableau& row, double step) {
  const auto field = fields::make_field("abc");
  TrajectoryOptions options = dopri5(1, 1e300);  // every step is accepted: steps of one size
  options.stepper = &row;
  options.max_step = step;
  const auto sampler = field->sampler();
  Trajectory path(options, abc_start, Vec3(0), *sampler);
  path.reach(1, *sampler);
  return glm::distance(path.at(1).x, abc_end_1);
}

TEST(PropertySteppers, EveryRowHasItsOrder) {
  for (const ButcherTableau& row : steppers()) {
    // Fine enough for the leading error term to dominate, coarse enough to stay clear of rounding.
    const double h = row.order == 1 ? 1. / 512 : row.order == 4 ? 1. / 32 : 1. / 16;
    const double order = std::log2(error_at_1(row, h) / error_at_1(row, h / 2));
    EXPECT_NEAR(order, row.order, row.order == 4 ? 0.1 : 0.2) << row.name;
  }
}

TEST(PropertySteppers, TableausAreConsistent) {
  for (const ButcherTableau& row : steppers()) {
    double sum_b = 0, sum_error = 0, sum_dense = 0;
    for (int i = 0; i < row.stages; ++i) {
      double sum_a = 0;
      for (int j = 0; j < i; ++j) sum_a += row.a[i][j];
      // Coefficients up to some 12, an ulp of 1.8e-15, which cancel.
      EXPECT_NEAR(sum_a, row.c[i], 1e-14) << row.name << " stage " << i;
      sum_b += row.b[i];
    }
    for (int i = 0; i <= row.stages; ++i) {
      sum_error += row.error[i];
      sum_dense += row.dense[i];
    }
    // Likewise.
    EXPECT_NEAR(sum_b, 1, 1e-14) << row.name;
    EXPECT_NEAR(sum_error, 0, 1e-14) << row.name;  // both of the pair are consistent
    EXPECT_NEAR(sum_dense, 0, 1e-12) << row.name;  // a constant slope needs no correction
  }
}

TEST(UnitTrajectory, Dopri5KeepsItsToleranceOnAbc) {
  const auto field = fields::make_field("abc");
  const TrajectoryOptions options = dopri5(10, 1e-8);
  CountingSampler sampler(*field);
  Trajectory path(options, abc_start, Vec3(0), sampler);
  ASSERT_TRUE(path.reach(10, sampler));
  // Errors of single steps add up and are stretched by the flow, here about fifty times.
  EXPECT_LE(glm::distance(path.at(10).x, abc_end_10), 5e-7);
  EXPECT_LE(sampler.evaluations(), 1000u);
  EXPECT_EQ(path.end(), EndReason::duration);
}

TEST(UnitTrajectory, DenseOutputIsExactBetweenSteps) {
  // A circle: the error between steps is that of a fourth order interpolant, above the tolerance of
  // the steps themselves.
  const auto field = everywhere([](const Vec3& x) { return Vec3(-x.y, x.x, 0.5); });
  const TrajectoryOptions options = dopri5(6, 1e-10);
  const auto sampler = field.sampler();
  Trajectory path(options, {1, 0, 0}, Vec3(0), *sampler);
  path.reach(6, *sampler);
  for (double t = 0; t <= 6; t += 0.037) {
    const FlowPoint point = path.at(t);
    // A tolerance of 1e-10 for each of some twenty steps; a velocity is a derivative over a step of
    // some 0.3, at its ends a few times as steep.
    EXPECT_LE(glm::distance(point.x, Vec3(std::cos(t), std::sin(t), 0.5 * t)), 2e-9) << t;
    EXPECT_LE(glm::distance(point.v, Vec3(-std::sin(t), std::cos(t), 0.5)), 2e-8) << t;
  }
}

TEST(UnitTrajectory, HillsStreamFunctionIsKept) {
  // Inside the unit sphere, ψ = (3/4) ρ² (1 - r²) is constant on stream lines.
  const auto psi = [](const Vec3& x) {
    return 0.75 * (x.x * x.x + x.y * x.y) * (1 - glm::dot(x, x));
  };
  // u_ρ = -(1/ρ) ∂ψ/∂z, u_z = (1/ρ) ∂ψ/∂ρ.
  const auto field = everywhere([](const Vec3& x) {
    const double rho2 = x.x * x.x + x.y * x.y;
    const double radial = 1.5 * x.z;
    return Vec3(radial * x.x, radial * x.y, 1.5 * (1 - x.z * x.z - 2 * rho2));
  });
  const TrajectoryOptions options = dopri5(50, 1e-9);
  const auto sampler = field.sampler();
  Trajectory path(options, {0.3, 0.1, 0.2}, Vec3(0), *sampler);
  ASSERT_TRUE(path.reach(50, *sampler));
  for (double t = 0; t <= 50; t += 0.5)
    // Measured 7e-10, less than a tolerance of 1e-9; some ten times that.
    EXPECT_NEAR(psi(path.at(t).x), psi({0.3, 0.1, 0.2}), 1e-8) << t;
}

TEST(UnitTrajectory, VariationIsTheDerivativeOfTheFlow) {
  // Saddle: ∂x/∂x₀ = diag(e^t, e^-t, 1), exactly.
  const auto field = fields::make_field("saddle");
  TrajectoryOptions options = dopri5(2);
  options.companion = Companion::variation;
  const auto sampler = field->sampler();
  Trajectory path(options, {0.5, 1, 0}, {1, 2, 3}, *sampler);
  path.reach(2, *sampler);
  // 1e-6 relative per step, and some twenty steps.
  EXPECT_LE(glm::distance(path.at(2).w, Vec3(std::exp(2), 2 * std::exp(-2), 3)), 1e-5);
}

TEST(UnitTrajectory, GhostsAgreeWithTheVariation) {
  const auto field = fields::make_field("abc");
  const auto direction = [&](Companion companion, double t) {
    TrajectoryOptions options = dopri5(5);
    options.companion = companion;
    const auto sampler = field->sampler();
    Trajectory path(options, abc_start, {1, 0, 0}, *sampler);
    path.reach(t, *sampler);
    const FlowPoint point = path.at(t);
    return glm::normalize(glm::cross(point.w, point.v));
  };
  for (double t = 0.5; t <= 5; t += 0.5)
    for (const Companion ghost : {Companion::ghost_reset, Companion::ghost_rescaled}) {
      const Vec3 truth = direction(Companion::variation, t), normal = direction(ghost, t);
      const double degrees = 57.29577951 * std::asin(glm::length(glm::cross(truth, normal)));
      // A ghost stands off by a small distance, whose second-order part is the angle. Measured
      // 3e-4; ten times that.
      EXPECT_LE(degrees, 3e-3) << t;
    }
}

TEST(UnitTrajectory, EndsAtTheEdgeOfTheDomain) {
  const auto field = boxed([](const Vec3&) { return Vec3(1, 0.25, 0); }, 1);
  const TrajectoryOptions options = dopri5(10);
  const auto sampler = field.sampler();
  Trajectory path(options, {0, 0, 0}, Vec3(0), *sampler);
  EXPECT_FALSE(path.reach(10, *sampler));
  EXPECT_EQ(path.end(), EndReason::left_domain);
  EXPECT_NEAR(path.time(), 1, 2e-6);  // 1000 tolerances short of the edge at most
  EXPECT_LE(path.time(), 1);
}

TEST(UnitTrajectory, EveryEndHasItsReason) {
  const auto end_of = [](const fields::VectorField& field, const TrajectoryOptions& options) {
    const auto sampler = field.sampler();
    Trajectory path(options, {0.5, 0, 0}, Vec3(0), *sampler);
    path.reach(options.duration, *sampler);
    return path.end();
  };
  const auto uniform = everywhere([](const Vec3&) { return Vec3(1, 0, 0); });
  const auto still = everywhere([](const Vec3&) { return Vec3(0); });
  const FunctionField hole([](const Vec3& x, double, Vec3& v) {
    v = Vec3(1, 0, 0);
    return x.x > 0.75 ? fields::SampleStatus::not_finite : fields::SampleStatus::ok;
  });
  EXPECT_EQ(end_of(uniform, dopri5(1)), EndReason::duration);
  EXPECT_EQ(end_of(still, dopri5(1)), EndReason::stagnated);
  EXPECT_EQ(end_of(hole, dopri5(1)), EndReason::not_finite);
  EXPECT_EQ(end_of(boxed([](const Vec3&) { return Vec3(1); }, 0.4), dopri5(1)), EndReason::outside);
  EXPECT_EQ(end_of(boxed([](const Vec3&) { return Vec3(1); }, 0.6), dopri5(1)),
            EndReason::left_domain);
  TrajectoryOptions limited = dopri5(1);
  limited.max_step = 0.01;
  limited.max_length = 0.3;
  EXPECT_EQ(end_of(uniform, limited), EndReason::length);
  limited.max_steps = 7;
  EXPECT_EQ(end_of(uniform, limited), EndReason::steps);
}

/// At the middle of a turn a particle rests from the beginning; into a sink one comes to rest.
TEST(UnitTrajectory, TheCompanionOfWhoRestsGoesOn) {
  const auto at_rest = [](const char* name, Companion companion, const Vec3& seed,
                          double duration) {
    const auto field = fields::make_field(name);
    const auto sampler = field->sampler();
    TrajectoryOptions options = dopri5(duration);
    options.companion = companion;
    options.still = 1e-12;
    Trajectory path(options, seed, {1, 0, 1}, *sampler);
    path.skip_to(duration, *sampler);
    EXPECT_EQ(path.end(), EndReason::stagnated) << name;
    return path.at_rest(duration, *sampler);
  };
  for (const Companion companion : {Companion::variation, Companion::conormal}) {
    const FlowPoint turned = at_rest("formula:u=-y,v=x,w=0", companion, {0, 0, 3}, 2);
    EXPECT_EQ(turned.x, Vec3(0, 0, 3));
    EXPECT_LE(glm::distance(turned.w, Vec3(std::cos(2), std::sin(2), 1)), 1e-14);
    // What dies away is e^-100 of the rest.
    const FlowPoint sunk = at_rest("formula:u=-x,v=-y,w=-2*z", companion, {1, 1, 1}, 100);
    const Vec3 wanted = companion == Companion::conormal ? Vec3(0, 0, 1) : Vec3(1, 0, 0);
    EXPECT_LE(glm::distance(glm::normalize(sunk.w), wanted), 1e-6);
  }
}

TEST(UnitTrajectory, StepsOverDiscontinuities) {
  // A shear layer of no thickness: the particle turns where it crosses y = 0.
  const auto field =
      everywhere([](const Vec3& x) { return x.y < 0 ? Vec3(1, 1, 0) : Vec3(-1, 1, 0); });
  const TrajectoryOptions options = dopri5(2);
  CountingSampler sampler(field);
  Trajectory path(options, {0, -1, 0}, Vec3(0), sampler);
  ASSERT_TRUE(path.reach(2, sampler));
  EXPECT_LE(glm::distance(path.at(2).x, Vec3(0, 1, 0)), 1e-6);  // some hundred steps across
  EXPECT_LE(sampler.evaluations(), 2000u);
}

TEST(UnitTrajectory, ScalesOfVelocityAndPlaceDoNotMatter) {
  for (const double scale : {1e-20, 1e20}) {
    const auto field = everywhere([=](const Vec3& x) { return scale * Vec3(-x.y, x.x, 0); });
    const TrajectoryOptions options = dopri5(1 / scale);
    const auto sampler = field.sampler();
    Trajectory path(options, {1, 0, 0}, Vec3(0), *sampler);
    ASSERT_TRUE(path.reach(options.duration, *sampler)) << scale;
    // A tolerance of 1e-9 for each of some ten steps.
    EXPECT_LE(glm::distance(path.at(options.duration).x, Vec3(std::cos(1), std::sin(1), 0)), 1e-8);
  }
  const Vec3 far(1e7, -1e7, 1e7);
  const auto field = everywhere([=](const Vec3& x) { return Vec3(far.y - x.y, x.x - far.x, 0); });
  const TrajectoryOptions options = dopri5(1);
  CountingSampler sampler(field);
  Trajectory path(options, far + Vec3(1, 0, 0), Vec3(0), sampler);
  ASSERT_TRUE(path.reach(1, sampler));
  // A position of 1e7 is known to 2e-9.
  EXPECT_LE(glm::distance(path.at(1).x, far + Vec3(std::cos(1), std::sin(1), 0)), 1e-6);
  EXPECT_LE(sampler.evaluations(), 2000u);
}

/// To a 300th of a mesh's tolerance, whatever accuracy its particles were given.
TEST(UnitTrajectory, TheTruthOfSamplesIsNoFinerThanItHasToBe) {
  TrajectoryOptions options = dopri5(2, 1e-7);
  options.max_move = 0.5;
  make_exact(options, 1, 1e-4);
  EXPECT_NEAR(options.error_floor, 0.03 * 1e-5 / 2, 1e-15);
  EXPECT_NEAR(options.tolerance, 1e-3 * 0.03 * 1e-5, 1e-18);
  // Of a formula it is what doubles allow.
  TrajectoryOptions formula = dopri5(2, 1e-7);
  make_exact(formula, 1, 1e-4);
  EXPECT_EQ(formula.error_floor, 0);
  EXPECT_EQ(formula.tolerance, 1e-13);
}

}  // namespace
}  // namespace pellucid::integrators
