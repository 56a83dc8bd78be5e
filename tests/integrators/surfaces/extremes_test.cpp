// SPDX-License-Identifier: GPL-3.0-or-later
// Where integrators break: every case ends, with a reason, and with a mesh that is sound and
// finite.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/error.h"
#include "integrators/mesh/mesh_quality.h"
#include "tests/integrators/closed_forms.h"
#include "tests/integrators/test_fields.h"
#include "tests/support/mesh_area.h"

namespace pellucid::integrators {
namespace {

using testing::boxed;
using testing::everywhere;
using testing::FunctionField;

const char* const adaptive[] = {"hultquist:threshold=0.1", "hultquist:tolerance=1e-2",
                                "adaptive-front:particles=9,threshold=0.1",
                                "adaptive-front:particles=9,tolerance=1e-2",
                                "fixed-front:particles=20,rows=20"};

void expect_sound(const IntegratedSurface& surface, std::string_view integrator) {
  const MeshQuality quality = measure_quality(surface.mesh);
  EXPECT_TRUE(quality.manifold) << integrator;
  EXPECT_EQ(quality.degenerate_triangles, 0u) << integrator;
  std::uint64_t ended = 0;
  for (const auto& [reason, count] : surface.stats.ends) ended += count;
  EXPECT_EQ(ended, surface.stats.particles) << integrator;
  for (const Vec3& x : surface.mesh.positions)
    ASSERT_TRUE(std::isfinite(x.x) && std::isfinite(x.y) && std::isfinite(x.z)) << integrator;
  // Normalized: three roundings of 1.1e-16.
  for (const Vec3& n : surface.mesh.normals) ASSERT_NEAR(glm::length(n), 1, 4e-16) << integrator;
}

IntegratedSurface sweep(const fields::VectorField& field, std::string_view integrator,
                        const SeedCurve& seed = segment_seed({-1, -1, 0}, {1, -1, 0.1}),
                        double duration = 3) {
  return integrate_surface(integrator, {&field, seed, duration, 0, false, {}});
}

TEST(UnitExtremes, LeavingTheDomainFollowsItsEdge) {
  const auto field = boxed([](const Vec3& x) { return Vec3(0.3 * x.y, 1, 0); }, 1);
  for (const char* integrator : adaptive) {
    const auto surface = sweep(field, integrator, segment_seed({-0.5, -0.9, 0}, {0.5, -0.9, 0}));
    expect_sound(surface, integrator);
    EXPECT_GT(surface.stats.ends.at(EndReason::left_domain), 0u) << integrator;
    // Steps that leave are halved down to ten tolerances, each 1e-9 of the domain's diagonal
    // of 3.5: see edge_tolerances.
    EXPECT_NEAR(surface.mesh.bounds().max.y, 1, 4e-8) << integrator;
  }
}

TEST(UnitExtremes, SeedsOutsideTheDomainAreCounted) {
  const auto field = boxed([](const Vec3&) { return Vec3(0, 0.3, 0); }, 1);
  const SeedCurve half_outside = segment_seed({0, -1, 0}, {2, -1, 0});
  for (const char* integrator : adaptive) {
    const auto surface = sweep(field, integrator, half_outside);
    expect_sound(surface, integrator);
    EXPECT_GT(surface.stats.ends.at(EndReason::outside), 0u) << integrator;
    EXPECT_LE(surface.mesh.bounds().max.x, 1) << integrator;
    // The curve is followed to the edge, but for the tearing distance or a fixed particle's place.
    EXPECT_GE(surface.mesh.bounds().max.x, 0.9) << integrator;
    EXPECT_THROW(sweep(field, integrator, segment_seed({3, 3, 3}, {4, 3, 3})), InputError);
  }
}

TEST(UnitExtremes, NoVelocityMakesNoSurfaceButSaysWhy) {
  const auto field = everywhere([](const Vec3&) { return Vec3(0); });
  for (const char* integrator : adaptive) {
    try {
      sweep(field, integrator);
      ADD_FAILURE() << integrator;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("stagnated"), std::string::npos) << error.what();
    }
  }
}

TEST(UnitExtremes, StagnationPointOnTheSeedCurve) {
  // The middle of the curve stands still, its neighbours leave on either side.
  const auto field = everywhere([](const Vec3& x) { return Vec3(x.x, x.y + 1, 0.2 * x.x); });
  for (const char* integrator : adaptive)
    expect_sound(sweep(field, integrator, segment_seed({-1, -1, 0}, {1, -0.9, 0}), 1), integrator);
}

TEST(UnitExtremes, NoSlipWall) {
  const auto field = everywhere([](const Vec3& x) { return Vec3(x.y, 0, 0); });
  for (const char* integrator : adaptive)
    expect_sound(sweep(field, integrator, segment_seed({0, 0, 0}, {0, 1, 0.1})), integrator);
}

TEST(UnitExtremes, ClosedOrbits) {
  const auto field = everywhere([](const Vec3& x) { return Vec3(-x.y, x.x, 0); });
  for (const char* integrator : adaptive)
    expect_sound(sweep(field, integrator, segment_seed({0.2, 0, 0}, {1, 0, 0.1}), 20), integrator);
}

TEST(UnitExtremes, HolesOfNoNumbers) {
  const FunctionField field([](const Vec3& x, double, Vec3& v) {
    v = Vec3(0, 1, 0);
    if (glm::length(x) < 0.4) v.x = std::numeric_limits<double>::quiet_NaN();
    return std::isnan(v.x) ? fields::SampleStatus::not_finite : fields::SampleStatus::ok;
  });
  for (const char* integrator : adaptive) {
    const auto surface = sweep(field, integrator);
    expect_sound(surface, integrator);
    EXPECT_GT(surface.stats.ends.at(EndReason::not_finite), 0u) << integrator;
    // Straight lines: no triangle lies in the hole's shadow, but for a front edge's lean.
    for (const auto& [a, b, c] : surface.mesh.triangles) {
      const Vec3 middle =
          (surface.mesh.positions[a] + surface.mesh.positions[b] + surface.mesh.positions[c]) / 3.0;
      ASSERT_FALSE(middle.y > 0.2 && std::abs(middle.x) < 0.2) << integrator;
    }
  }
}

TEST(UnitExtremes, DiscontinuousVelocity) {
  const auto field = everywhere([](const Vec3& x) { return Vec3(x.x > 0 ? 0.5 : -0.5, 1, 0); });
  for (const char* integrator : {"hultquist:threshold=0.1", "hultquist:tolerance=1e-2"}) {
    const auto surface = sweep(field, integrator);
    expect_sound(surface, integrator);
    EXPECT_EQ(measure_quality(surface.mesh).sheets, 2u) << integrator;
  }
}

TEST(UnitExtremes, ScaledAndShiftedScenesGiveTheSameMesh) {
  const auto count = [](double scale, const Vec3& shift) {
    const auto field = everywhere([=](const Vec3& x) {
      const Vec3 local = (x - shift) / scale;
      return scale * Vec3(-local.y, local.x, 0.3);
    });
    // Without symmetry: equal diagonals would be decided by rounding.
    const SeedCurve seed =
        segment_seed(shift + scale * Vec3(0.2, 0, 0), shift + scale * Vec3(1, 0.1, 0.07));
    const std::string integrator =
        "hultquist:threshold=" + std::to_string(0.1 * scale) + ",normals=none";
    return double(
        integrate_surface(integrator, {&field, seed, 2, 0, false, {}}).mesh.triangles.size());
  };
  const double expected = count(1, Vec3(0));
  EXPECT_NEAR(count(1e10, Vec3(0)), expected, 0.01 * expected);  // ties of diagonals may differ
  EXPECT_NEAR(count(1, Vec3(1e7)), expected, 0.01 * expected);
}

TEST(UnitExtremes, VelocitiesOfAnySize) {
  for (const double speed : {1e-20, 1e20}) {
    const auto field = everywhere([=](const Vec3& x) { return speed * Vec3(-x.y, x.x, 0.3); });
    for (const char* integrator : adaptive)
      expect_sound(sweep(field, integrator, segment_seed({0.2, 0, 0}, {1, 0, 0}), 2 / speed),
                   integrator);
  }
}

TEST(UnitExtremes, BudgetsEndTheWork) {
  const auto field = fields::make_field("abc");
  const SeedCurve seed = segment_seed({2.64, 3.14, 3.14}, {3.64, 3.14, 3.14});
  const auto ends = [&](const std::string& integrator) {
    const auto surface = integrate_surface(integrator, {field.get(), seed, 5, 0, false, {}});
    expect_sound(surface, integrator);
    return surface.stats.ends;
  };
  EXPECT_GT(ends("hultquist:max-triangles=500")[EndReason::triangles], 0u);
  EXPECT_GT(ends("hultquist:tolerance=1e-14,max-triangles=2000")[EndReason::triangles], 0u);
  EXPECT_GT(ends("adaptive-front:max-triangles=5000")[EndReason::triangles], 0u);
  EXPECT_GT(
      ends("adaptive-front:particles=9,tolerance=1e-14,max-triangles=2000")[EndReason::triangles],
      0u);
  EXPECT_GT(ends("hultquist:length=2")[EndReason::length], 0u);
  EXPECT_GT(ends("hultquist:max-steps=50")[EndReason::steps], 0u);
  const auto few = integrate_surface("hultquist:particles=30,max-particles=40",
                                     {field.get(), seed, 5, 0, false, {}});
  EXPECT_LE(few.stats.particles, 40u);
}

/// A fixed front of fine rows has an area of 2.15.
TEST(UnitExtremes, TolerancesLargerThanTheSurfaceMakeACoarseMesh) {
  const auto field = fields::make_field("abc");
  for (const char* integrator :
       {"hultquist:tolerance=3", "hultquist:tolerance=1e6", "adaptive-front:tolerance=10",
        "adaptive-front:particles=2,tolerance=10", "adaptive-front:threshold=1000"}) {
    const auto surface = sweep(*field, integrator, segment_seed({0, 0, 0}, {0, 1, 0}), 1);
    expect_sound(surface, integrator);
    EXPECT_GE(surface.mesh.triangles.size(), 4u) << integrator;
    EXPECT_NEAR(testing::area_of(surface.mesh), 2.15, 0.1) << integrator;
  }
}

TEST(UnitExtremes, RepeatedPointsOfTheSeedCurve) {
  const auto field = fields::make_field("abc");
  const std::vector<Vec3> points{{2, 3, 3}, {2, 3, 3}, {2.5, 3, 3}, {2.5, 3, 3}, {2.5, 3.5, 3.2}};
  for (const char* integrator : adaptive)
    expect_sound(sweep(*field, integrator, polyline_seed(points), 2), integrator);
}

TEST(UnitExtremes, WrongCallsAreRefused) {
  const auto field = fields::make_field("abc");
  const SeedCurve seed = segment_seed({0, 0, 0}, {1, 0, 0});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double duration : {0., -1., nan, std::numeric_limits<double>::infinity()})
    EXPECT_THROW(integrate_surface("hultquist", {field.get(), seed, duration, 0, false, {}}),
                 InputError);
  EXPECT_THROW(integrate_surface("hultquist", {field.get(), seed, 1, nan, false, {}}), InputError);
  for (const char* integrator :
       {"hultqist", "hultquist:threshold=0", "hultquist:tolerance=0", "hultquist:tolerance=nan",
        "hultquist:tolerance=1e-3,threshold=0.1", "hultquist:particles=1", "hultquist:colour=red",
        "fixed-front:rows=0", "hultquist:stepper=rk5"})
    EXPECT_THROW(integrate_surface(integrator, {field.get(), seed, 1, 0, false, {}}), InputError)
        << integrator;
}

}  // namespace
}  // namespace pellucid::integrators
