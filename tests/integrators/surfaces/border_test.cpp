// SPDX-License-Identifier: GPL-3.0-or-later
// Where surfaces end: at whichever face, obstacle, length or time each of their particles comes to
// first. Flows are straight, so that the area is known: the integral of how long a particle lasts.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "fields/make_field.h"
#include "fields/sampled/dense_field.h"
#include "integrators/mesh/mesh_quality.h"
#include "integrators/surfaces/integrate_surface.h"
#include "tests/integrators/test_fields.h"
#include "tests/support/mesh_area.h"

namespace pellucid::integrators {
namespace {

constexpr double tolerance = 1e-3;

/// An obstacle on the way, the square from low to high in x and y; empty where high < low.
struct Obstacle {
  double low = 1, high = 0;
};

/// Samples of (1, slope, 0) over 0 <= x, y <= 8, a quarter apart, none strictly inside the
/// obstacle: the cells beside one that is missing are missing, too, up to its edge.
std::unique_ptr<fields::VectorField> straight(double slope, const Obstacle& obstacle = {}) {
  const fields::Axis axis = fields::Axis::uniform(0, 0.25, 33);
  std::vector<glm::vec3> samples;
  const auto inside = [&](int i) { return 0.25 * i > obstacle.low && 0.25 * i < obstacle.high; };
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 33; ++j)
      for (int i = 0; i < 33; ++i) {
        const float u = inside(i) && inside(j) ? std::numeric_limits<float>::quiet_NaN() : 1.f;
        samples.emplace_back(u, float(slope), 0.f);
      }
  fields::DenseGrid<glm::vec3> grid{
      {axis, axis, fields::Axis::uniform(0, 1, 3)}, std::move(samples), std::nullopt};
  return fields::make_dense_field(std::move(grid), fields::Interpolation::linear, "straight");
}

const SeedCurve across = segment_seed({0.5, 0.5, 1}, {0.5, 7.5, 1});

/// How long the particle from (0.5, y) lasts.
double lifetime(double y, double slope, double duration, const Obstacle& obstacle) {
  const double last = std::min({duration, 7.5, slope > 0 ? (8 - y) / slope : duration});
  const double front = obstacle.low - 0.5, there = y + slope * front;  // at its face of constant x
  if (there > obstacle.low && there < obstacle.high) return std::min(last, front);
  const double below = (obstacle.low - y) / slope;  // at its face of constant y
  if (slope > 0 && below > front && 0.5 + below < obstacle.high) return std::min(last, below);
  return last;
}

double exact_area(double slope, double duration, const Obstacle& obstacle = {}) {
  constexpr int seeds = 100'000;
  double sum = 0;
  for (int i = 0; i < seeds; ++i)
    sum += lifetime(0.5 + 7 * (i + 0.5) / seeds, slope, duration, obstacle);
  return 7 * sum / seeds;  // |∂x/∂y × (1, slope, 0)| = 1
}

/// The surface lies where it should, but for the tolerance along its border, whose length is at
/// most 30 around it and 6 around an obstacle.
void expect_area(const IntegratedSurface& surface, double exact, const std::string& what) {
  const MeshQuality quality = measure_quality(surface.mesh);
  EXPECT_NEAR(testing::area_of(surface.mesh), exact, 36 * tolerance) << what;
  EXPECT_EQ(quality.sheets, 1u) << what;
  EXPECT_TRUE(quality.manifold) << what;
  EXPECT_EQ(quality.degenerate_triangles, 0u) << what;
}

std::string named(const std::string& integrator, double slope, double duration) {
  return integrator + ", slope " + std::to_string(slope) + ", T " + std::to_string(duration);
}

class PropertyBorder : public ::testing::TestWithParam<const char*> {};

/// The front leaves through the face at x = 8, the one at y = 8, and the corner between them.
TEST_P(PropertyBorder, FrontsLeaveThroughTwoFacesWhole) {
  for (const double slope : {0.05, 0.3, 0.8})
    for (const double duration : {3., 7.5, 20.}) {
      const auto field = straight(slope);
      const auto surface =
          integrate_surface(GetParam(), {field.get(), across, duration, 0, false, {}});
      expect_area(surface, exact_area(slope, duration), named(GetParam(), slope, duration));
    }
}

/// Nobody, some or all of those that pass the obstacle leave the domain before the time is over.
/// Steps as short as these do not cut its corners.
TEST_P(PropertyBorder, NoFrontBridgesAnObstacle) {
  constexpr Obstacle obstacle{3.25, 4.75};
  for (const double slope : {0., 0.3})
    for (const double duration : {5., 7.5, 20.}) {
      const auto field = straight(slope, obstacle);
      const std::string integrator = GetParam() + std::string(",cells=0.1");
      const auto surface =
          integrate_surface(integrator, {field.get(), across, duration, 0, false, {}});
      expect_area(surface, exact_area(slope, duration, obstacle),
                  named(integrator, slope, duration));
    }
}

/// Lengths end particles as faces do.
TEST_P(PropertyBorder, NoFrontOfALengthBridgesAnObstacle) {
  constexpr Obstacle obstacle{3.25, 4.75};
  const auto field = straight(0, obstacle);
  const auto surface = integrate_surface(GetParam() + std::string(",length=6"),
                                         {field.get(), across, 7, 0, false, {}});
  expect_area(surface, exact_area(0, 6, obstacle), GetParam());
}

/// Radially from the line x + y = 1, by e^T, out of the square 0 <= x, y <= 2 and its corner.
TEST_P(PropertyBorder, ARadialFlowFillsTheCorner) {
  const auto field = testing::boxed([](const Vec3& x) { return Vec3(x.x, x.y, 0); }, 2);
  for (const auto& [duration, area] :
       {std::pair(std::log(1.5), 0.625), {std::log(3.), 3.}, {10., 3.5}}) {
    const auto surface = integrate_surface(
        GetParam(), {&field, segment_seed({1, 0, 0}, {0, 1, 0}), duration, 0, false, {}});
    expect_area(surface, area, named(GetParam(), 1, duration));
  }
}

INSTANTIATE_TEST_SUITE_P(, PropertyBorder,
                         ::testing::Values("hultquist:tolerance=1e-3",
                                           "adaptive-front:particles=5,tolerance=1e-3"));

/// A helicoid of radii 0.5 to 2 and pitch c: the integral of √(r² + c²) dr is half of
/// r √(r² + c²) + c² asinh(r / c).
double helicoid_area(double c, double duration) {
  const auto primitive = [&](double r) {
    return 0.5 * (r * std::sqrt(r * r + c * c) + c * c * std::asinh(r / c));
  };
  return duration * (primitive(2) - primitive(0.5));
}

TEST(UnitBudget, WithoutParticlesASurfaceGetsCoarseAndNotHoles) {
  const auto field = fields::make_field("rotation:c=0.3");
  const SeedCurve seed = segment_seed({0.5, 0, 0}, {2, 0, 0});
  for (const char* budget : {"12", "100", "260"})
    for (const std::string integrator : {"hultquist:", "adaptive-front:particles=5,"}) {
      const auto surface = integrate_surface(integrator + "tolerance=1e-4,max-particles=" + budget,
                                             {field.get(), seed, 3, 0, false, {}});
      EXPECT_EQ(measure_quality(surface.mesh).sheets, 1u) << integrator << budget;
      // A chord over two seeds of a line is exact; one along a step has its sagitta.
      EXPECT_NEAR(testing::area_of(surface.mesh), helicoid_area(0.3, 3), 0.02)
          << integrator << budget;
      EXPECT_LE(surface.stats.particles, std::stoul(budget)) << integrator;
    }
}

TEST(UnitBudget, TheEndOfParticlesIsNamed) {
  const auto field = fields::make_field("abc");
  const auto surface = integrate_surface(
      "hultquist:tolerance=1e-4,max-particles=40",
      {field.get(), segment_seed({2.64, 3.14, 3.14}, {3.64, 3.14, 3.14}), 5, 0, false, {}});
  EXPECT_GT(surface.stats.ends.at(EndReason::particles), 0u);
}

/// Steps over which nothing moves would make no triangle, and go on for ever.
TEST(UnitBudget, StepsTooShortToBeOneEndByTriangles) {
  const auto field = fields::make_field("rotation");
  for (const char* integrator :
       {"hultquist:step=1e-20,max-triangles=1000", "hultquist:tolerance=1e-30,max-triangles=1000",
        "adaptive-front:particles=5,step=1e-20,max-triangles=1000"}) {
    const auto surface = integrate_surface(
        integrator, {field.get(), segment_seed({1, 0, 0}, {2, 0, 0}), 1, 0, false, {}});
    EXPECT_GT(surface.stats.ends.at(EndReason::triangles), 0u) << integrator;
  }
}

/// 10 000 turns within a row take 3e5 steps, of which none is kept.
TEST(UnitBudget, AFixedFrontKeepsNoneOfTheWayWithinARow) {
  const auto field = fields::make_field("rotation");
  const auto surface =
      integrate_surface("fixed-front:particles=2,rows=1,accuracy=1e-6",
                        {field.get(), segment_seed({1, 0, 0}, {2, 0, 0}), 1e4, 0, false, {}});
  EXPECT_LT(surface.stats.bytes, 100'000u);
}

}  // namespace
}  // namespace pellucid::integrators
