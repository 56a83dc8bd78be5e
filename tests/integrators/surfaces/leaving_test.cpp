// SPDX-License-Identifier: GPL-3.0-or-later
// Fronts that leave a domain obliquely: what lies between two particles that have left it at
// different times is still one sheet.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "integrators/mesh/mesh_quality.h"
#include "integrators/surfaces/integrate_surface.h"
#include "tests/integrators/test_fields.h"
#include "tests/support/mesh_area.h"

namespace pellucid::integrators {
namespace {

IntegratedSurface leave(const fields::VectorField& field, std::string_view integrator,
                        const SeedCurve& seed, double duration) {
  return integrate_surface(integrator, {&field, seed, duration, 0, false, {}});
}

struct Crossing {
  Vec3 from, to;
  double area;
};

/// Along x through the cube |x| <= 2: triangles and trapezia up to x = 2, and from y = -1.5 to 1.5.
constexpr Crossing crossings[] = {{{-2, -1.5, 0}, {2, 1.5, 0}, 6},
                                  {{-1, -1.5, 0}, {1, 1.5, 0}, 6},
                                  {{1, -1.5, 0}, {-1, 1.5, 0}, 6},
                                  {{-2, -1.5, 0}, {1.9, 1.5, 0}, 6.15}};

TEST(UnitLeaving, UniformFlowMakesOneFlatSheet) {
  const auto field = testing::boxed([](const Vec3&) { return Vec3(1, 0, 0); }, 2);
  for (const auto& [from, to, area] : crossings)
    for (const char* integrator :
         {"adaptive-front:tolerance=1e-3", "adaptive-front:particles=2,tolerance=1e-3",
          "hultquist:tolerance=1e-3", "hultquist:threshold=0.1", "adaptive-front:threshold=0.1"}) {
      const auto surface = leave(field, integrator, segment_seed(from, to), 10);
      EXPECT_NEAR(testing::area_of(surface.mesh), area, 1e-5) << integrator;
      EXPECT_EQ(measure_quality(surface.mesh).sheets, 1u) << integrator;
    }
}

/// Nothing tears where particles leave, also of two that leave one after the other: the ribbon
/// between them ends with the first, and with it the way of the other.
TEST(UnitLeaving, WhoIsLeftAloneEndsForItsNeighboursReason) {
  const auto field = testing::boxed([](const Vec3&) { return Vec3(1, 0.5, 0); }, 2);
  for (const int particles : {2, 3, 5, 20}) {
    const auto surface = leave(field, "fixed-front:particles=" + std::to_string(particles),
                               segment_seed({-2, -2, 0}, {-2, 1, 0}), 10);
    EXPECT_EQ(surface.stats.ends, (EndCounts{{EndReason::left_domain, std::uint64_t(particles)}}));
  }
}

/// A helicoid that leaves through several faces: 800 particles of 800 rows come to 2.1409, and the
/// other integrators to within 0.1 % of each other.
TEST(UnitLeaving, HelicoidsKeepTogetherAtTheEdge) {
  const auto field = testing::boxed([](const Vec3& x) { return Vec3(-x.y, x.x, 0.3); }, 1);
  const SeedCurve seed = segment_seed({0.3, -0.3, -0.5}, {0.9, 0.5, -0.2});
  for (const char* integrator : {"adaptive-front:tolerance=1e-3", "hultquist:tolerance=1e-3",
                                 "adaptive-front:threshold=0.1"}) {
    const auto surface = leave(field, integrator, seed, 6);
    const MeshQuality quality = measure_quality(surface.mesh);
    EXPECT_NEAR(testing::area_of(surface.mesh), 2.1411, 1e-3) << integrator;
    EXPECT_EQ(quality.sheets, 1u) << integrator;
    EXPECT_TRUE(quality.manifold) << integrator;
  }
}

}  // namespace
}  // namespace pellucid::integrators
