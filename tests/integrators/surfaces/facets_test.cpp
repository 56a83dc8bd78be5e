// SPDX-License-Identifier: GPL-3.0-or-later
// Facets that stand off the surface are mended: by turning edges, and by vertices on the surface.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numbers>

#include "integrators/mesh/mesh_quality.h"
#include "integrators/surfaces/surface_error.h"
#include "tests/integrators/closed_forms.h"
#include "tests/support/mesh_area.h"

namespace pellucid::integrators {
namespace {

using testing::closed_forms;
using testing::sweep;

/// Where the front leans along the flow, its triangles would be turned over.
SurfaceRequest abc_request(const fields::VectorField& field, double duration) {
  return {&field, segment_seed({3.1, 3.1, 0.1}, {3.1, 3.1, 6.1}), duration, 0, false, {}};
}

TEST(PropertyFacets, NoneOfTheAbcSurfaceStandsOffIt) {
  const auto field = fields::make_field("abc");
  const SurfaceRequest request = abc_request(*field, 9);
  for (const IntegratorRow& row : integrators()) {
    if (!row.promises.refines) continue;
    for (const char* fineness : {"tolerance=0.002", "threshold=0.1"}) {
      const std::string integrator = fmt::format("{}:{}", row.name, fineness);
      const geometry::TriangleMesh mesh = integrate_surface(integrator, request).mesh;
      const MeshQuality quality = measure_quality(mesh);
      // Normals of vertices are exact, by the variational equation, and all facets are asked.
      EXPECT_LE(quality.normal_degrees.max, 30) << integrator;
      EXPECT_LE(measure_error(mesh, request, 500).normal_max_degrees, 30) << integrator;
      EXPECT_TRUE(quality.manifold) << integrator;
      EXPECT_EQ(quality.degenerate_triangles, 0u) << integrator;
      // As the front made them some are turned over: the test can fail.
      const auto as_made = integrate_surface(integrator + ",facet-angle=180", request).mesh;
      EXPECT_GT(measure_quality(as_made).normal_degrees.max, 60) << integrator;
    }
  }
}

TEST(PropertyFacets, AnyAngleCanBeAskedFor) {
  constexpr double angle = 4;  // degrees
  for (const auto& form : closed_forms())
    for (const IntegratorRow& row : integrators()) {
      if (!row.promises.refines) continue;
      const auto swept =
          sweep(form, fmt::format("{}:threshold=0.2,facet-angle={}", row.name, angle));
      const MeshQuality quality = measure_quality(swept.surface.mesh);
      EXPECT_LE(quality.normal_degrees.max, angle) << form.name << " " << row.name;
      EXPECT_TRUE(quality.manifold) << form.name << " " << row.name;
      EXPECT_EQ(quality.sheets, 1u) << form.name << " " << row.name;
      for (const Vec3& x : swept.surface.mesh.positions)
        ASSERT_LE(testing::implicit_distance(form, x), testing::trajectory_error)
            << form.name << " " << row.name;
      std::uint64_t ended = 0;
      for (const auto& [reason, count] : swept.surface.stats.ends) ended += count;
      EXPECT_EQ(ended, swept.surface.stats.particles) << form.name << " " << row.name;
    }
}

TEST(PropertyFacets, NoEdgeIsSplitTwiceInTheSamePlace) {
  // These surfaces stay whole and lean most where they end.
  const auto field = fields::make_field("abc");
  const double pi = std::numbers::pi;
  const SurfaceRequest request{
      field.get(), segment_seed({pi, pi, pi - 3}, {pi, pi, pi + 3}), 9, 0, false, {}};
  for (const char* integrator :
       {"adaptive-front:tolerance=0.01,rip=1e-8", "hultquist:tolerance=0.01,rip=1e-8"}) {
    const auto surface = integrate_surface(integrator, request);
    const MeshQuality quality = measure_quality(surface.mesh);
    EXPECT_GT(surface.stats.ends.at(EndReason::vertex), 0u) << integrator;
    EXPECT_EQ(quality.duplicate_vertices, 0u) << integrator;
    EXPECT_EQ(quality.degenerate_triangles, 0u) << integrator;
    EXPECT_TRUE(quality.manifold) << integrator;
  }
}

TEST(UnitFacets, MendingComesToAnEnd) {
  // Whole to the end, this surface asks for more vertices on its border than it has.
  const auto field = fields::make_field("abc");
  const auto surface =
      integrate_surface("hultquist:threshold=0.1,rip=1e-8", abc_request(*field, 9));
  EXPECT_LE(surface.stats.ends.at(EndReason::vertex), 5000 + surface.mesh.positions.size() / 100);
  EXPECT_TRUE(measure_quality(surface.mesh).manifold);
}

TEST(UnitFacets, OverTheSeamOfAClosedCurve) {
  const auto field = fields::make_field("rotation:omega=1,c=1");
  const SurfaceRequest request{field.get(), circle_seed({1, 0, 0}, {0, 1, 0}, 0.3), 2, 0, false,
                               {}};
  const auto surface = integrate_surface("hultquist:threshold=0.2,facet-angle=6", request);
  const MeshQuality quality = measure_quality(surface.mesh);
  EXPECT_GT(surface.stats.ends.at(EndReason::vertex), 0u);
  EXPECT_LE(quality.normal_degrees.max, 6);
  EXPECT_TRUE(quality.manifold);
}

struct Unmendable {
  const char* field;
  Vec3 from, to;
};

/// Through a vortex's centre normals turn their other side, and beside a particle at rest (s, t)
/// tells nothing: there facets stay as the front made them, and the rest is not spoilt for it.
TEST(PropertyFacets, MendingLeavesNothingWorse) {
  constexpr Unmendable cases[] = {{"hill", {0, 0.3, 0}, {0, 0.9, 0}},
                                  {"rotation:c=0", {-1, 0, -0.3}, {1, 0, 0.3}}};
  for (const auto& [name, from, to] : cases) {
    const auto field = fields::make_field(name);
    const SurfaceRequest request{field.get(), segment_seed(from, to), 6, 0, false, {}};
    const auto mended = integrate_surface("hultquist:tolerance=2e-2", request);
    const auto made = integrate_surface("hultquist:tolerance=2e-2,facet-angle=180", request);
    const MeshQuality now = measure_quality(mended.mesh), before = measure_quality(made.mesh);
    EXPECT_LE(now.normal_degrees.max, before.normal_degrees.max + 1e-6) << name;
    EXPECT_LE(now.normal_degrees.p99, before.normal_degrees.p99 + 1e-6) << name;
    EXPECT_EQ(now.degenerate_triangles, 0u) << name;
    EXPECT_EQ(now.duplicate_vertices, 0u) << name;
    const double area = testing::area_of(made.mesh);
    EXPECT_NEAR(testing::area_of(mended.mesh), area, 1e-3 * area) << name;
    const auto error = measure_error(mended.mesh, request, 200);
    EXPECT_LE(error.max, measure_error(made.mesh, request, 200).max + 2e-3) << name;
    EXPECT_LT(mended.stats.particles, 2 * made.stats.particles + 100) << name;
  }
}

}  // namespace
}  // namespace pellucid::integrators
