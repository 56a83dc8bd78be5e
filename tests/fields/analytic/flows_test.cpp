// SPDX-License-Identifier: GPL-3.0-or-later
// What each flow of the catalogue is known for: closed forms, kept quantities, symmetries, limits.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "fields/make_field.h"
#include "tests/fields/probe.h"

namespace pellucid::fields {
namespace {

using std::numbers::pi;

Mat3 jacobian_of(std::string_view field, const Vec3& x, double t = 0) {
  const auto made = make_field(field);
  Vec3 v;
  Mat3 jacobian;
  EXPECT_EQ(made->sampler()->velocity_and_jacobian(x, t, v, jacobian), SampleStatus::ok);
  return jacobian;
}

/// ∮ v · dx around a circle about `center` in the plane of the unit vectors a and b.
double circulation(std::string_view field, const Vec3& center, const Vec3& a, const Vec3& b,
                   double radius) {
  constexpr int count = 400;  // spectrally accurate on a circle
  const auto made = make_field(field);
  double sum = 0;
  for (int i = 0; i < count; ++i) {
    const double phi = 2 * pi * i / count;
    const Vec3 v = velocity_of(*made, center + radius * (std::cos(phi) * a + std::sin(phi) * b));
    sum += glm::dot(v, std::cos(phi) * b - std::sin(phi) * a) * radius * 2 * pi / count;
  }
  return sum;
}

TEST(UnitFlows, UnsteadyClosedForms) {
  EXPECT_NEAR_VEC(velocity_of("drift", {3, 4, 5}, 0.7), Vec3(std::cos(0.7), std::sin(0.7), 0), 0);
  EXPECT_NEAR_VEC(velocity_of("pulsing-saddle", {3, 4, 5}, pi), Vec3(-3, 4, 0), 1e-15);
}

TEST(UnitFlows, DoubleGyreIsClosedAndSwings) {
  for (const double t : {0.0, 1.3, 7.9}) {
    // sin π is 1.2e-16 in double, and 0.1 π times that 4e-17.
    EXPECT_NEAR(velocity_of("double-gyre", {0, 0.4, 0}, t).x, 0, 1e-16);
    EXPECT_NEAR(velocity_of("double-gyre", {2, 0.4, 0}, t).x, 0, 1e-16);
    EXPECT_NEAR(velocity_of("double-gyre", {0.7, 0, 0}, t).y, 0, 1e-16);
    EXPECT_NEAR(velocity_of("double-gyre", {0.7, 1, 0}, t).y, 0, 1e-16);
  }
  EXPECT_NEAR_VEC(velocity_of("double-gyre", {0.5, 0, 0}), Vec3(-0.1 * pi, 0, 0.1), 1e-16);
  // At ωt = π/2 the border between the gyres is where 0.25x² + 0.5x = 1: x = √5 - 1.
  EXPECT_NEAR(velocity_of("double-gyre", {std::sqrt(5.0) - 1, 0.5, 0}, 2.5).x, 0, 1e-15);
}

double hill_stream_function(const Vec3& x) {
  const double rho2 = x.x * x.x + x.y * x.y, r = glm::length(x);
  return r < 1 ? -0.75 * rho2 * (1 - r * r) : 0.5 * rho2 * (1 - 1 / (r * r * r));
}

TEST(UnitFlows, HillKeepsItsStreamFunction) {
  for (const Vec3& x : {Vec3(0.3, 0.4, 0.2), Vec3(-0.1, 0.6, -0.7), Vec3(1, 0.5, -0.8)}) {
    const Vec3 v = velocity_of("hill", x);
    const double h = 1e-5;  // central differences: truncation and rounding near 1e-10
    EXPECT_NEAR(hill_stream_function(x + h * v) - hill_stream_function(x - h * v), 0, 1e-9 * h);
    const Vec3 z_step(0, 0, h);
    const double slope =
        (hill_stream_function(x + z_step) - hill_stream_function(x - z_step)) / (2 * h);
    const double rho = std::hypot(x.x, x.y);
    // The differences' error over the smallest distance from the axis, 1/2.
    EXPECT_NEAR((v.x * x.x + v.y * x.y) / rho, -slope / rho, 1e-8);
  }
}

TEST(UnitFlows, HillIsContinuousAndUniformFarAway) {
  const Vec3 on = glm::normalize(Vec3(1, -2, 1.5));
  EXPECT_NEAR_VEC(velocity_of("hill:U=3,a=2", 2.0000001 * on),
                  velocity_of("hill:U=3,a=2", 1.9999999 * on), 1e-5);
  EXPECT_NEAR_VEC(velocity_of("hill:U=3", 1e4 * on), Vec3(0, 0, 3), 1e-10);
  EXPECT_NEAR_VEC(velocity_of("hill:U=2", Vec3(0)), Vec3(0, 0, -3), 1e-15);
}

TEST(UnitFlows, BenzeneIsAGradientWithSixfoldSymmetry) {
  const Vec3 x(0.7, 1.9, 0.4);
  const Mat3 jacobian = jacobian_of("benzene", x);
  // Products of the same factors in another order: an ulp of terms below 1.
  EXPECT_LE(norm(jacobian - glm::transpose(jacobian)), 1e-15);
  const Mat3 turn(std::cos(pi / 3), std::sin(pi / 3), 0, -std::sin(pi / 3), std::cos(pi / 3), 0, 0,
                  0, 1);
  EXPECT_NEAR_VEC(velocity_of("benzene", turn * x), turn * velocity_of("benzene", x), 1e-15);
  // Neutral, and symmetric, so that what is left far away is a quadrupole: r⁻⁴.
  const double near = glm::length(velocity_of("benzene", {0, 0, 50})),
               far = glm::length(velocity_of("benzene", {0, 0, 100}));
  EXPECT_NEAR(near / far, 16, 0.1);
}

// Around a straight tube the field is ε²/π(ρ² + ε²)²; the knot's curvature of up to 0.6 changes
// that by some of ε = 0.3.
TEST(UnitFlows, TrefoilFollowsItsAxis) {
  for (const double s : {0.3, 1.1, 4.0}) {
    const double r = 1.6 + std::sin(3 * s), slope = 3 * std::cos(3 * s);
    const Vec3 axis(r * std::sin(2 * s), r * std::cos(2 * s), std::cos(3 * s));
    const Vec3 tangent = glm::normalize(Vec3(slope * std::sin(2 * s) + 2 * r * std::cos(2 * s),
                                             slope * std::cos(2 * s) - 2 * r * std::sin(2 * s),
                                             -3 * std::sin(3 * s)));
    const Vec3 field = velocity_of("trefoil:eps=0.3,twist=0", axis);
    EXPECT_GT(glm::dot(glm::normalize(field), tangent), 0.99);
    EXPECT_NEAR(glm::length(field) * pi * 0.09, 1, 0.1);
  }
}

TEST(UnitFlows, TheTrefoilsCurrentIsTheFluxInATube) {
  // Ampère: the circulation of the twist around the tube is the current within, up to the tube's
  // tails and the other strands.
  const double s = 0.5 * pi;  // the outermost point of a strand: r = 0.6 there is the inner one
  const double r = 1.6 + std::sin(3 * s);
  const Vec3 axis(r * std::sin(2 * s), r * std::cos(2 * s), std::cos(3 * s));
  const Mat3 with = jacobian_of("trefoil:twist=1", axis),
             without = jacobian_of("trefoil:twist=0", axis);
  const Mat3 twist = with - without;
  const Vec3 curl(twist[1][2] - twist[2][1], twist[2][0] - twist[0][2], twist[0][1] - twist[1][0]);
  EXPECT_NEAR_VEC(curl, velocity_of("trefoil:twist=0", axis), 1e-9);
}

TEST(UnitFlows, KelvinHelmholtzStartsAsTanhAndKeepsItsStreamFunction) {
  EXPECT_NEAR_VEC(velocity_of("kelvin-helmholtz:c=1,drift=0", {2, 0.7, 1}),
                  Vec3(std::tanh(0.7), 0, 0), 1e-15);
  const auto psi = [](const Vec3& x) {
    return std::log(1.25 * std::cosh(x.y) + 0.75 * std::cos(x.x));
  };
  const Vec3 x(1, 0.8, 0), v = velocity_of("kelvin-helmholtz:drift=0", x);
  // Central differences leave h³ ψ''' |v|³ / 3, some 1e-15, and psi rounds by 1e-16.
  EXPECT_NEAR(psi(x + 1e-5 * v) - psi(x - 1e-5 * v), 0, 1e-14);
  EXPECT_NEAR_VEC(velocity_of("kelvin-helmholtz", {2, -900, 1}), Vec3(-1, 0, 0.25), 1e-15);
}

TEST(UnitFlows, DeltaWingVorticesAreAPairWithDownwash) {
  const Vec3 x(1.5, 0.3, 0.4), mirrored(1.5, -0.3, 0.4);
  const Vec3 v = velocity_of("delta-wing", x), w = velocity_of("delta-wing", mirrored);
  EXPECT_NEAR_VEC(w, Vec3(v.x, -v.y, v.z), 1e-15);
  EXPECT_LT(velocity_of("delta-wing:alpha=0", {2, 0, 0.24}).z, -0.3);
  EXPECT_GT(velocity_of("delta-wing:alpha=0", {2, 1.2, 0.24}).z, 0.1);
  // Far from the apex, in a plane across the right vortex: Γ r²/(r² + ε²) of an endless filament,
  // less what lies beyond the circle by less than a percent.
  const Vec3 d = glm::normalize(Vec3(1, 0.35, 0.12));
  const Vec3 a = glm::normalize(glm::cross(d, Vec3(0, 0, 1))), b = glm::cross(d, a);
  EXPECT_NEAR(circulation("delta-wing:U=0", 20.0 * d, a, b, 0.5), 1.5 * 0.25 / 0.2536, 0.01);
}

TEST(UnitFlows, RotorWakeTurnsWithItsRotor) {
  const Vec3 x(0.7, 0.2, -0.3);
  const double t = 0.8, c = std::cos(t), s = std::sin(t);
  const Mat3 turn(c, s, 0, -s, c, 0, 0, 0, 1);
  EXPECT_NEAR_VEC(velocity_of("rotor-wake", turn * x, t), turn * velocity_of("rotor-wake", x),
                  1e-13);
  EXPECT_NEAR_VEC(velocity_of("rotor-wake:blades=2", x, pi), velocity_of("rotor-wake", x), 1e-12);
  EXPECT_LT(velocity_of("rotor-wake", {0.3, 0, -0.3}).z, -0.5);  // down inside
  EXPECT_GT(velocity_of("rotor-wake", {1.5, 0, -0.3}).z, 0);     // up outside
}

TEST(UnitFlows, StepHasAStreamABubbleAndAWall) {
  EXPECT_NEAR_VEC(velocity_of("step", {6, 1.9, 1}), Vec3(1, 0, 0),
                  0.03);  // the bubble displaces it
  EXPECT_LT(velocity_of("step:roll=0,rib=0", {3, -0.7, 1}).x, -0.1);
  EXPECT_GT(velocity_of("step:roll=0,rib=0", {9, 0.3, 1}).x, 0.5);
  // At the wall both factors of v are 0 or sin π, 1.2e-16.
  for (const double x : {0.5, 4.0, 11.0})
    EXPECT_NEAR(velocity_of("step:roll=0,rib=0", {x, -1, 2}).y, 0, 1e-16);
  EXPECT_EQ(status_at(*make_field("step"), {-0.1, 0, 1}), SampleStatus::outside);
}

TEST(UnitFlows, SphereIsStokesFlowWhenSlow) {
  const Vec3 on = glm::normalize(Vec3(0.3, -1, 0.5));
  // No slip up to O(Re); 3/8 Re is the next term's size.
  EXPECT_LE(glm::length(velocity_of("sphere:Re=0.001", 1.0000001 * on)), 1e-3);
  const Vec3 x(1.2, 0.9, -0.4);
  const double r = glm::length(x), stokeslet = 0.75 * (1 / r + 1 / (3 * r * r * r));
  const Vec3 stokes =
      Vec3(1 - stokeslet, 0, 0) - 0.75 * x.x * (1 / std::pow(r, 3) - 1 / std::pow(r, 5)) * x;
  EXPECT_NEAR_VEC(velocity_of("sphere:Re=0.001", x), stokes, 1e-3);
}

TEST(UnitFlows, SphereHasItsWakeDownstream) {
  EXPECT_EQ(velocity_of("sphere", {0.3, 0.2, 0}), Vec3(0));
  EXPECT_NEAR_VEC(velocity_of("sphere:Re=20", {-200, 0, 0}), Vec3(1, 0, 0), 1e-3);
  EXPECT_LT(velocity_of("sphere:Re=20", {10, 0, 0}).x, 0.9);
  EXPECT_GT(velocity_of("sphere:Re=20", {10, 5, 0}).x, 0.98);
}

TEST(UnitFlows, ShedWakeIsTheSphereAndItsRings) {
  const auto of_rings = [](const Vec3& x) {
    return velocity_of("shed-wake:rings=1,gamma=0.8", x) - velocity_of("sphere", x);
  };
  EXPECT_EQ(velocity_of("shed-wake:rings=0", {3, 0.5, 0}), velocity_of("sphere", {3, 0.5, 0}));
  // g = -Γ/2 and g_z = 0 on the circle s = R²: v = -Γ n; at the centre -Γ exp(-R²/8σ²) n. n as the
  // flow has it, R = 0.75, σ = 0.2.
  const Vec3 center(2.2, 0.35, 0), n(std::cos(0.6), std::sin(0.6), 0);
  EXPECT_NEAR_VEC(of_rings(center + 0.75 * Vec3(0, 0, 1)), -0.8 * n, 1e-14);
  EXPECT_NEAR_VEC(of_rings(center), -0.8 * std::exp(-0.75 * 0.75 / (8 * 0.04)) * n, 1e-14);
  EXPECT_EQ(velocity_of("shed-wake", {0.9, 0.2, 0}), Vec3(0));
  double largest = 0;  // on the sphere
  for (double angle = 0; angle < 1.6; angle += 0.01)
    for (double turn = 0; turn < 6.3; turn += 0.1)
      largest =
          std::max(largest, glm::length(of_rings(1.000001 * Vec3(cos(angle), sin(angle) * cos(turn),
                                                                 sin(angle) * sin(turn)))));
  EXPECT_GT(largest, 0);
  // What rings of opposite circulation leave on the sphere; a share of 0.002 of the rings' speed,
  // measured, of 0.8.
  EXPECT_LT(largest, 0.002 * 0.8);
}

}  // namespace
}  // namespace pellucid::fields
