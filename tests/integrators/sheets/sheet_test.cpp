// SPDX-License-Identifier: GPL-3.0-or-later
// Streak and time surfaces: seeds of every kind, and what ends, tears, rests or turns back.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <numbers>

#include "core/error.h"
#include "fields/make_field.h"
#include "fields/sampled/dense_field.h"
#include "integrators/mesh/mesh_quality.h"
#include "integrators/sheets/integrate_sheet.h"
#include "integrators/sheets/sheet_error.h"
#include "integrators/surfaces/integrate_surface.h"
#include "tests/integrators/closed_forms.h"
#include "tests/integrators/sheets/sheet_requests.h"
#include "tests/integrators/test_fields.h"
#include "tests/support/mesh_area.h"

namespace pellucid::integrators {
namespace {

using testing::streak_of;
using testing::time_surface_of;

constexpr double pi = std::numbers::pi;

/// In a steady flow streak surfaces are stream surfaces.
TEST(AgreementSheets, StreakSurfacesOfSteadyFlowsAreStreamSurfaces) {
  const auto field = fields::make_field("abc");
  const SeedCurve seed = segment_seed({2.6, 3.1, 3.1}, {3.6, 3.1, 3.1});
  const IntegratedSheet streak =
      integrate_sheet("streak-surface:tolerance=1e-3", streak_of(*field, seed, 4));
  const IntegratedSurface stream =
      integrate_surface("hultquist:tolerance=1e-3", {field.get(), seed, 4, 0, false, {}});
  const double area = testing::area_of(stream.mesh);
  EXPECT_NEAR(testing::area_of(streak.mesh), area, 1e-3 * area);
}

TEST(UnitSheets, VerticesAreWhereTheFlowMapHasThem) {
  const auto field = fields::make_field("drift");
  constexpr double end = 2.5, start = 0.4;
  const IntegratedSheet sheet =
      integrate_sheet("streak-surface:tolerance=1e-3",
                      streak_of(*field, segment_seed({0, 0, 0}, {0, 0, 2}), end - start, start));
  const auto& scalars = sheet.mesh.scalars;
  for (std::size_t i = 0; i < sheet.mesh.positions.size(); ++i) {
    const double released = scalars.at("released")[i];
    const Vec3 wanted(std::sin(end) - std::sin(released), std::cos(released) - std::cos(end),
                      2 * scalars.at("s")[i]);
    EXPECT_LE(glm::distance(sheet.mesh.positions[i], wanted), testing::trajectory_error);
    EXPECT_NEAR(scalars.at("t")[i], end - released, 1e-15 * end);
    EXPECT_EQ(scalars.at("time")[i], end);
    EXPECT_NEAR(scalars.at("speed")[i], 1, 1e-12);
  }
  // An arc of 2.1 around a cylinder of length 2.
  EXPECT_NEAR(testing::area_of(sheet.mesh), 2 * (end - start), 2e-3 * 2 * (end - start));
}

TEST(UnitSheets, AClosedSeedClosesTheSheet) {
  const auto field = fields::make_field("formula:u=0,v=0,w=1+0*x");
  const IntegratedSheet tube =
      integrate_sheet("streak-surface:tolerance=1e-4",
                      streak_of(*field, circle_seed({0, 0, 0}, {0, 0, 1}, 0.5), 2));
  const MeshQuality quality = measure_quality(tube.mesh);
  EXPECT_EQ(quality.sheets, 1u);
  EXPECT_NEAR(testing::area_of(tube.mesh), 2 * pi, 1e-3);
  // A tube has Euler's characteristic 0; cut open along a seam it would be a disc, which has 1.
  const std::size_t faces = tube.mesh.triangles.size();
  const std::size_t edges = (3 * faces + quality.boundary_edges) / 2;
  EXPECT_EQ(tube.mesh.positions.size() + faces, edges);
  EXPECT_EQ(quality.non_manifold_edges, 0u);
}

/// The edges of a square tube stay sharp, and no facet spans a crease.
TEST(UnitSheets, CornersOfASeedAreCreases) {
  const auto field = fields::make_field("formula:u=0,v=0,w=1+0*x");
  const Vec3 square[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const IntegratedSheet tube =
      integrate_sheet("streak-surface", streak_of(*field, polyline_seed(square, true), 1));
  EXPECT_NEAR(testing::area_of(tube.mesh), 4, 1e-12);
}

TEST(UnitSheets, AMeshIsASeed) {
  const auto field = fields::make_field("pulsing-saddle");
  geometry::TriangleMesh tent;
  tent.positions = {{0.5, 0, 0}, {1, 0, 0.5}, {1, 1, 0.5}, {0.5, 1, 0}, {1.5, 0, 0},
                    {1.5, 1, 0}, {1, 0, 0.5}, {1, 1, 0.5}};  // the ridge twice, as files have it
  tent.triangles = {{0, 1, 2}, {0, 2, 3}, {6, 4, 5}, {6, 5, 7}};
  constexpr double duration = 0.9;
  const IntegratedSheet sheet = integrate_sheet("time-surface:tolerance=1e-3",
                                                time_surface_of(*field, mesh_seed(tent), duration));
  EXPECT_EQ(measure_quality(sheet.mesh).sheets, 1u);
  // The flow is linear: each of the two flat sides becomes another flat one.
  const double f = std::exp(std::sin(duration));
  const double side = std::hypot(0.5 * f, 0.5) / f;
  EXPECT_NEAR(testing::area_of(sheet.mesh), 2 * side, 1e-9);
  const SurfaceError error =
      measure_sheet_error(sheet, time_surface_of(*field, mesh_seed(tent), duration), 500,
                          sheet_parameters("time-surface:tolerance=1e-3"));
  EXPECT_LE(error.max, 1e-8);
  EXPECT_LE(error.max_from_surface, 1e-8);
}

/// Along x through the cube |x| <= 1 for a time of 10 the particles let go at x = -0.5 within the
/// last 1.5 are there; obliquely placed seeds have a slanted border.
TEST(UnitSheets, TheSheetEndsWhereItsParticlesHaveLeft) {
  const auto field = testing::boxed([](const Vec3&) { return Vec3(1, 0, 0); }, 1);
  for (const auto& [from, to, area] : {std::tuple(Vec3(-0.5, -0.5, 0), Vec3(-0.5, 0.5, 0), 1.5),
                                       std::tuple(Vec3(-0.9, -0.5, 0), Vec3(0.7, 0.5, 0), 1.1)}) {
    const IntegratedSheet sheet = integrate_sheet("streak-surface:tolerance=1e-3",
                                                  streak_of(field, segment_seed(from, to), 10));
    EXPECT_NEAR(testing::area_of(sheet.mesh), area, 1e-6);
    EXPECT_EQ(measure_quality(sheet.mesh).sheets, 1u);
    EXPECT_GT(sheet.stats.ends.at(EndReason::left_domain), 0u);
    for (const Vec3& x : sheet.mesh.positions) EXPECT_LE(x.x, 1);
  }
}

/// A round hole of radius 0.3 in a patch that stands still: what is left is a square without a
/// disc.
TEST(UnitSheets, TheBorderFollowsAHole) {
  const testing::FunctionField field([](const Vec3& x, double, Vec3& v) {
    v = Vec3(0, 0, 1);
    return std::hypot(x.x, x.y) < 0.3 ? fields::SampleStatus::outside : fields::SampleStatus::ok;
  });
  const SeedSurface patch = patch_seed({-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
  for (const double tolerance : {1e-2, 1e-3}) {
    const IntegratedSheet sheet = integrate_sheet(
        "time-surface:tolerance=" + std::to_string(tolerance), time_surface_of(field, patch, 1));
    // A border within the tolerance of the circle: at most its length times that.
    EXPECT_NEAR(testing::area_of(sheet.mesh), 4 - pi * 0.09, 2 * pi * 0.3 * tolerance);
    EXPECT_EQ(measure_quality(sheet.mesh).sheets, 1u);
  }
}

/// Left of a line the flow goes up, right of it down: two sheets, parted where the line is.
TEST(UnitSheets, AJumpTearsTheSheet) {
  const auto field = testing::everywhere(
      [](const Vec3& x) { return Vec3(0, 0, x.x + 0.3 * x.y < 0.1234 ? 1 : -1); });
  const IntegratedSheet sheet =
      integrate_sheet("time-surface:tolerance=1e-3",
                      time_surface_of(field, patch_seed({-1, 0, 0}, {2, 0, 0}, {0, 1, 0}), 1));
  EXPECT_EQ(measure_quality(sheet.mesh).sheets, 2u);
  EXPECT_NEAR(testing::area_of(sheet.mesh), 2, 1e-6);
  EXPECT_GT(sheet.stats.ends.at(EndReason::torn), 0u);
  EXPECT_LT(sheet.stats.particles, 50'000u);
}

/// On one side of a line the flow goes up faster: the strip between the two sheets' ends is no part
/// of the sheet, though it lies in its plane, and where the particles are young the jump is short.
TEST(UnitSheets, AJumpAlongTheFlowTearsTheSheet) {
  for (const double at : {0.3, 0.1, 0.25})
    for (const double fast : {2., 3.}) {
      const auto field =
          testing::everywhere([=](const Vec3& x) { return Vec3(0, 0, x.x < at ? 1 : fast); });
      const IntegratedSheet sheet = integrate_sheet(
          "streak-surface", streak_of(field, segment_seed({-1, 0, 0}, {1, 0, 0}), 1));
      const double area = 1 + at + fast * (1 - at);
      EXPECT_NEAR(testing::area_of(sheet.mesh), area, 1e-3) << at << ' ' << fast;
      EXPECT_GT(sheet.stats.ends.at(EndReason::torn), 0u) << at << ' ' << fast;
      EXPECT_FALSE(sheet.stats.ends.contains(EndReason::particles)) << at << ' ' << fast;
      EXPECT_LT(sheet.mesh.triangles.size(), 10'000u) << at << ' ' << fast;
    }
}

TEST(UnitSheets, NoSheetComesOfSeedsAlongTheFlow) {
  const auto field = fields::make_field("rotation:c=0");
  EXPECT_THROW(integrate_sheet("streak-surface",
                               streak_of(*field, circle_seed({0, 0, 0}, {0, 0, 1}, 0.5), 3)),
               InputError);
  // Along the flow at first, across it later.
  const auto turning = fields::make_field("formula:u=1,v=t,w=0");
  const IntegratedSheet sheet =
      integrate_sheet("streak-surface", streak_of(*turning, segment_seed({0, 0, 0}, {1, 0, 0}), 2));
  EXPECT_GT(testing::area_of(sheet.mesh), 0.5);
}

/// The line is a circle: a disc goes up, and its rim is a polygon within the tolerance.
TEST(UnitSheets, ATearMayBeCurved) {
  const auto field = testing::everywhere(
      [](const Vec3& x) { return Vec3(0, 0, std::hypot(x.x, x.y) < 0.4 ? 1 : -1); });
  const IntegratedSheet sheet =
      integrate_sheet("time-surface:tolerance=1e-3",
                      time_surface_of(field, patch_seed({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), 1));
  EXPECT_EQ(measure_quality(sheet.mesh).sheets, 2u);
  double disc = 0;
  for (const auto& [a, b, c] : sheet.mesh.triangles) {
    const auto& x = sheet.mesh.positions;
    if (x[a].z > 0) disc += 0.5 * glm::length(glm::cross(x[b] - x[a], x[c] - x[a]));
  }
  EXPECT_NEAR(disc, pi * 0.16, 2 * pi * 0.4 * 1e-3);
  EXPECT_NEAR(testing::area_of(sheet.mesh), 4, 2 * 2 * pi * 0.4 * 1e-3);
}

/// The domain's edge is that of a row of facets. Beyond it, where seeds are forgiven a rounding,
/// all particles start on the edge: what facets have there are lines.
TEST(UnitSheets, ABorderThroughVerticesHasNoSlivers) {
  const fields::Axis axis = fields::Axis::uniform(0, 0.1, 11);
  fields::DenseGrid<glm::vec3> grid{
      {axis, axis, axis}, std::vector<glm::vec3>(11 * 11 * 11, glm::vec3(1, 0.5, 0)), std::nullopt};
  const auto field =
      fields::make_dense_field(std::move(grid), fields::Interpolation::linear, "uniform");
  const IntegratedSheet sheet =
      integrate_sheet("streak-surface:tolerance=1e-3",
                      streak_of(*field, segment_seed({0.2, -0.5, 0.3}, {0.2, 0.5, 0.3}), 2));
  const MeshQuality quality = measure_quality(sheet.mesh);
  EXPECT_EQ(quality.sheets, 1u);
  EXPECT_EQ(quality.degenerate_triangles, 0u);
  EXPECT_EQ(quality.duplicate_vertices, 0u);
  EXPECT_EQ(quality.non_manifold_vertices, 0u);
  EXPECT_NEAR(testing::area_of(sheet.mesh), 0.4, 1e-6);
}

/// Chaos stretches the sheet to many times its width, and does not tear it.
TEST(UnitSheets, WhatIsStretchedIsWhole) {
  const auto field = fields::make_field("double-gyre");
  const IntegratedSheet sheet =
      integrate_sheet("streak-surface:tolerance=2e-2,particles=9",
                      streak_of(*field, segment_seed({1, 0.2, 0}, {1, 0.2, 0.1}), 11));
  EXPECT_EQ(measure_quality(sheet.mesh).sheets, 1u);
  EXPECT_FALSE(sheet.stats.ends.contains(EndReason::torn));
}

/// The flow turns at t = π/2, where particles are let go at rest: the streak surface turns back
/// there, and both its sides lie on each other. With x = X exp(1 - sin t) at the end t = π/2 + 1
/// for seeds along z, each covers the strip from X to X exp(1 - sin(end)).
TEST(UnitSheets, AFlowThatTurnsFoldsTheSheet) {
  const auto field = fields::make_field("pulsing-saddle");
  const double end = pi / 2 + 1, begin = pi / 2 - 1;
  const IntegratedSheet sheet =
      integrate_sheet("streak-surface:tolerance=1e-3",
                      streak_of(*field, segment_seed({1, 0, 0}, {1, 0, 1}), end - begin, begin));
  const double width = 1 - std::exp(std::sin(end) - 1);
  // Of either sheet the edge may be off by the tolerance.
  EXPECT_NEAR(testing::area_of(sheet.mesh), 2 * width, 2e-3);
  EXPECT_LT(sheet.mesh.triangles.size(), 100'000u);
}

TEST(UnitSheets, ParticlesAtRestStayWhereTheyAre) {
  // At rest until t = 1, then along x.
  const testing::FunctionField field(
      [](const Vec3&, double t, Vec3& v) {
        v = Vec3(t < 1 ? 0 : 1, 0, 0);
        return fields::SampleStatus::ok;
      },
      false);
  const IntegratedSheet sheet = integrate_sheet(
      "streak-surface:tolerance=1e-3", streak_of(field, segment_seed({0, 0, 0}, {0, 1, 0}), 3));
  // Where the flow sets in, and where it ends, the edge may be off by the tolerance.
  EXPECT_NEAR(testing::area_of(sheet.mesh), 2, 2e-3);
}

/// The Jacobian of a linear flow is the same everywhere, so that a plane stays one, and all normals
/// are that of it: of the particles on the axis, which rest, as of all others.
TEST(UnitSheets, NormalsOfParticlesAtRestTurnWithTheFlow) {
  constexpr double time = 2;
  const struct {
    const char* field;
    Vec3 side, normal;  // of the patch, beside the z axis, which rests; of what it becomes
  } flows[] = {{"formula:u=-y,v=x,w=0", {2, 0, 0}, {-std::sin(time), std::cos(time), 0}},
               {"formula:u=x,v=-y,w=0", {1, -1, 0}, {std::exp(-time), std::exp(time), 0}}};
  for (const auto& [name, side, normal] : flows) {
    const auto field = fields::make_field(name);
    const IntegratedSheet sheet =
        integrate_sheet("time-surface:tolerance=1e-2",
                        time_surface_of(*field, patch_seed(-0.5 * side, side, {0, 0, 1}), time));
    std::size_t resting = 0;
    for (std::size_t i = 0; i < sheet.mesh.positions.size(); ++i) {
      const Vec3& x = sheet.mesh.positions[i];
      resting += std::hypot(x.x, x.y) == 0;
      EXPECT_NEAR(std::abs(glm::dot(sheet.mesh.normals[i], glm::normalize(normal))), 1, 1e-6) << i;
    }
    EXPECT_GT(resting, 2u) << name;
  }
}

/// Particles of speed 1: those older than 2 have run their length.
TEST(UnitSheets, EndsAreThoseOfVerticesAndOfPlacesThatAreGone) {
  const auto field = fields::make_field("drift");
  const IntegratedSheet sheet =
      integrate_sheet("streak-surface:tolerance=1e-2,length=2",
                      streak_of(*field, segment_seed({0, 0, 0}, {0, 0, 1}), 4, 0.3));
  const EndCounts& ends = sheet.stats.ends;
  EXPECT_EQ(ends.at(EndReason::duration), sheet.mesh.positions.size());
  EXPECT_GT(ends.at(EndReason::length), 0u);
  EXPECT_EQ(ends.size(), 2u);
}

TEST(UnitSheets, AnUnfinishedSheetSaysSo) {
  const auto field = fields::make_field("abc");
  const IntegratedSheet sheet =
      integrate_sheet("streak-surface:tolerance=1e-6,max-particles=5000",
                      streak_of(*field, segment_seed({2.6, 3.1, 3.1}, {3.6, 3.1, 3.1}), 4));
  EXPECT_GT(sheet.stats.ends.at(EndReason::particles), 0u);
  // The last look may send one to each side, of which there are up to twice as many as before in
  // each of two directions.
  EXPECT_LE(sheet.stats.particles, 5u * 5000u);
}

TEST(UnitSheets, TheSameForAnyNumberOfThreads) {
  const auto field = fields::make_field("double-gyre");
  const auto request = streak_of(*field, segment_seed({0.9, 0.2, 0}, {1.1, 0.2, 1}), 5);
  const IntegratedSheet many = integrate_sheet("streak-surface:tolerance=1e-2", request);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const IntegratedSheet single = integrate_sheet("streak-surface:tolerance=1e-2", request);
  EXPECT_EQ(many.mesh.positions, single.mesh.positions);
  EXPECT_EQ(many.mesh.triangles, single.mesh.triangles);
}

TEST(UnitSheets, WrongRequestsAreRefused) {
  const auto field = fields::make_field("drift");
  const SeedCurve curve = segment_seed({0, 0, 0}, {0, 0, 1});
  EXPECT_THROW(integrate_sheet("time-surface", streak_of(*field, curve, 1)), InputError);
  EXPECT_THROW(integrate_sheet("streak-surface:tolerance=0", streak_of(*field, curve, 1)),
               InputError);
  EXPECT_THROW(integrate_sheet("streak-surfaces", streak_of(*field, curve, 1)), InputError);
  EXPECT_THROW(integrate_sheet("streak-surface", streak_of(*field, curve, 0)), InputError);
  EXPECT_THROW(patch_seed({0, 0, 0}, {1, 0, 0}, {2, 0, 0}), InputError);
  EXPECT_THROW(sphere_seed({0, 0, 0}, 0), InputError);
  EXPECT_THROW(mesh_seed({}), InputError);
}

}  // namespace
}  // namespace pellucid::integrators
