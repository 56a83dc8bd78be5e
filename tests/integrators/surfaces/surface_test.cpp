// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces against closed forms, and every row of the table against its promises.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <tbb/global_control.h>

#include <cmath>

#include "integrators/mesh/mesh_quality.h"
#include "integrators/surfaces/surface_error.h"
#include "tests/integrators/closed_forms.h"
#include "tests/support/mesh_area.h"

namespace pellucid::integrators {
namespace {

using testing::closed_forms;
using testing::ClosedForm;
using testing::largest_distance;
using testing::sweep;
using testing::worst_facet;

class PropertySurfaces : public ::testing::TestWithParam<ClosedForm> {};

INSTANTIATE_TEST_SUITE_P(ClosedForms, PropertySurfaces, ::testing::ValuesIn(closed_forms()),
                         [](const auto& form) { return form.param.name; });

TEST_P(PropertySurfaces, VerticesLieOnTheSurface) {
  for (const IntegratorRow& row : integrators()) {
    const auto swept = sweep(GetParam(), row.name);
    for (const Vec3& x : swept.surface.mesh.positions)
      ASSERT_LE(testing::implicit_distance(GetParam(), x), testing::trajectory_error) << row.name;
  }
}

TEST_P(PropertySurfaces, ErrorIsOfSecondOrder) {
  const auto error = [&](const std::string& integrator) {
    return largest_distance(GetParam(), sweep(GetParam(), integrator).surface.mesh);
  };
  const double coarse = error("fixed-front:particles=33,rows=48");
  const double fine = error("fixed-front:particles=65,rows=96");
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.15);
}

TEST_P(PropertySurfaces, FacetNormalsConverge) {
  const auto error = [&](const std::string& integrator) {
    const auto swept = sweep(GetParam(), integrator);
    return measure_error(swept.surface.mesh, swept.request, 1000).normal_mean_degrees;
  };
  const double coarse = error("fixed-front:particles=17,rows=24");
  const double fine = error("fixed-front:particles=33,rows=48");
  // First order; what the samples of the two meshes hit differs by a few percent.
  EXPECT_GE(std::log2(coarse / fine), 0.9);
}

TEST_P(PropertySurfaces, ToleranceBoundsTheError) {
  for (const IntegratorRow& row : integrators()) {
    if (!row.promises.bounds_error) continue;
    for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
      const auto swept =
          sweep(GetParam(),
                std::string(row.name) + ":particles=2,tolerance=" + std::to_string(tolerance));
      EXPECT_LE(largest_distance(GetParam(), swept.surface.mesh), tolerance)
          << row.name << " tolerance " << tolerance;
    }
  }
}

TEST_P(PropertySurfaces, FacetsTiltInFirstOrderOfTheirEdges) {
  // A sagitta κ h² / 8 within the tolerance allows edges h that shrink with its square root, to a
  // 32nd for a 1024th of it, and a facet's tilt is of first order in h. Ribbons are halved, so that
  // a mesh uses between half and all of what its tolerance allows, and one mesh may by chance use
  // half where the other uses all: that leaves half of 32.
  constexpr double coarse = 1.6e-2, shrinkage = 32;
  for (const IntegratorRow& row : integrators()) {
    if (!row.promises.bounds_error) continue;
    const auto worst = [&](double tolerance) {
      const auto integrator =
          fmt::format("{}:particles=2,tolerance={},facet-angle=180", row.name, tolerance);
      return worst_facet(GetParam(), sweep(GetParam(), integrator).surface.mesh);
    };
    EXPECT_GE(worst(coarse) / worst(coarse / (shrinkage * shrinkage)), shrinkage / 2) << row.name;
  }
}

TEST_P(PropertySurfaces, MeshesAreSound) {
  for (const std::string integrator :
       {"fixed-front:particles=40,rows=60", "adaptive-front:particles=9,threshold=0.1",
        "hultquist:threshold=0.05", "hultquist:tolerance=1e-3",
        "adaptive-front:particles=2,tolerance=1e-3"}) {
    const auto swept = sweep(GetParam(), integrator);
    const MeshQuality quality = measure_quality(swept.surface.mesh);
    EXPECT_TRUE(quality.manifold) << integrator;
    EXPECT_EQ(quality.non_manifold_edges, 0u) << integrator;
    EXPECT_EQ(quality.misoriented_edges, 0u) << integrator;
    EXPECT_EQ(quality.duplicate_vertices, 0u) << integrator;
    EXPECT_EQ(quality.unused_vertices, 0u) << integrator;
    EXPECT_EQ(quality.degenerate_triangles, 0u) << integrator;
    EXPECT_EQ(quality.sheets, 1u) << integrator;
    EXPECT_LE(measure_error(swept.surface.mesh, swept.request, 500).normal_max_degrees, 30)
        << integrator;
  }
}

TEST_P(PropertySurfaces, EveryParticleEndsForAReason) {
  for (const IntegratorRow& row : integrators()) {
    const auto swept = sweep(GetParam(), row.name);
    std::uint64_t ended = 0;
    for (const auto& [reason, count] : swept.surface.stats.ends) ended += count;
    EXPECT_EQ(ended, swept.surface.stats.particles) << row.name;
  }
}

TEST_P(PropertySurfaces, VerticesCarryTheirParameters) {
  const auto swept = sweep(GetParam(), "hultquist:threshold=0.2");
  const geometry::TriangleMesh& mesh = swept.surface.mesh;
  for (const char* name : {"s", "t", "time", "speed"})
    ASSERT_EQ(mesh.scalars.at(name).size(), mesh.positions.size());
  const auto sampler = swept.field->sampler();
  double longest = 0;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const double t = mesh.scalars.at("t")[i];
    longest = std::max(longest, t);
    Vec3 v;
    sampler->velocity(mesh.positions[i], swept.request.path ? t : 0, v);
    // Speeds and normals are from the derivative of a trajectory's dense output, of an order less
    // than its place. Measured 2e-7 and 3e-8; ten times that.
    EXPECT_NEAR(mesh.scalars.at("speed")[i], glm::length(v), 2e-6);
    EXPECT_NEAR(glm::length(mesh.normals[i]), 1, 4e-16);  // three roundings
    EXPECT_NEAR(glm::dot(mesh.normals[i], v), 0, 3e-7);
  }
  EXPECT_EQ(longest, GetParam().duration);
}

TEST(UnitSurface, HalfSaddleInFiftyThousandTriangles) {
  const ClosedForm form = closed_forms()[1];
  ASSERT_EQ(form.name, "HalfSaddle");
  const auto swept = sweep(form, "hultquist:tolerance=5e-5");
  EXPECT_LE(swept.surface.mesh.triangles.size(), 50000u);
  // The tolerance that was asked for.
  EXPECT_LE(largest_distance(form, swept.surface.mesh), 5e-5);
  EXPECT_LE(worst_facet(form, swept.surface.mesh), 1);
}

TEST(UnitSurface, CrossingASeparatrixGivesTwoSheets) {
  for (const char* integrator :
       {"hultquist:tolerance=1e-2", "adaptive-front:particles=9,tolerance=1e-2"}) {
    ClosedForm form{"", "saddle", testing::wave_seed(-1, 1, 0.2, 3), 5, false, testing::wave};
    const auto swept = sweep(form, integrator);
    const geometry::TriangleMesh& mesh = swept.surface.mesh;
    EXPECT_EQ(measure_quality(mesh).sheets, 2u) << integrator;
    EXPECT_LE(swept.surface.stats.particles, 2000u) << integrator;
    for (const auto& [a, b, c] : mesh.triangles) {
      const double x0 = mesh.positions[a].x, x1 = mesh.positions[b].x, x2 = mesh.positions[c].x;
      ASSERT_TRUE((x0 >= 0 && x1 >= 0 && x2 >= 0) || (x0 <= 0 && x1 <= 0 && x2 <= 0)) << integrator;
    }
  }
}

TEST(UnitSurface, PathIsNotStream) {
  // At time 0 the drift goes along x: its stream surface is a plane, its path surface a cylinder.
  ClosedForm form = closed_forms()[4];
  form.path = false;
  const auto stream = sweep(form, "hultquist");
  // sin 0 is 0: nothing moves along y.
  for (const Vec3& x : stream.surface.mesh.positions) ASSERT_EQ(x.y, 0);
  form.path = true;
  EXPECT_GT(sweep(form, "hultquist").surface.mesh.bounds().max.y, 1.9);
}

/// There the field stands still, and an attribute is that of the field that was followed.
TEST(UnitSurface, AStreamSurfaceIsAtItsStartTime) {
  const ClosedForm form = closed_forms()[4];
  const auto field = fields::make_field(form.field);
  const SurfaceRequest request{field.get(), form.seed, 1, 2, false, {}};
  for (const char* integrator : {"hultquist", "adaptive-front", "fixed-front"}) {
    const geometry::TriangleMesh mesh = integrate_surface(integrator, request).mesh;
    EXPECT_THAT(mesh.scalars.at("time"), ::testing::Each(2)) << integrator;
    EXPECT_THAT(mesh.scalars.at("t"), ::testing::Contains(::testing::Gt(0.5))) << integrator;
  }
}

TEST(UnitSurface, StartTimeShiftsTheField) {
  ClosedForm form = closed_forms()[4];
  const auto field = fields::make_field(form.field);
  SurfaceRequest request{field.get(), form.seed, 1, 2, true, {}};
  const geometry::TriangleMesh mesh = integrate_surface("hultquist", request).mesh;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const double t = mesh.scalars.at("t")[i], s = mesh.scalars.at("s")[i];
    EXPECT_EQ(mesh.scalars.at("time")[i], t + 2);
    const Vec3 expected = form.seed.point_at(s) +
                          Vec3(std::sin(2 + t) - std::sin(2), std::cos(2) - std::cos(2 + t), 0);
    EXPECT_LE(glm::distance(mesh.positions[i], expected), testing::trajectory_error);
  }
}

/// Without a stagnation point on its way a surface has no separatrix: that some of it is far ahead
/// of its neighbour, and much faster, tears nothing.
TEST(UnitSurface, AFlowThatSpeedsUpIsNotTorn) {
  const auto field = fields::make_field("formula:u=x,v=y,w=z");
  const SurfaceRequest request{field.get(), segment_seed({0.1, -3, 0}, {0.1, 1, 0}), 2, 0, false,
                               {}};
  const IntegratedSurface surface = integrate_surface("hultquist:tolerance=1e-2", request);
  EXPECT_EQ(measure_quality(surface.mesh).sheets, 1u);
  EXPECT_EQ(surface.stats.ends.count(EndReason::torn), 0u);
  // The triangle of the origin and the seeds grows by exp(2 * 2); its sides are straight.
  const double area = 0.5 * 0.1 * 4 * (std::exp(4) - 1);
  EXPECT_NEAR(testing::area_of(surface.mesh), area, 1e-6 * area);
}

/// By T = 5 neighbours whose seeds are 1e-4 of the curve apart have parted near the flow's
/// stagnation points, but the surface between them is stretched, not torn: trajectories depend
/// continuously on their seeds.
TEST(UnitSurface, StretchingDoesNotTearTheAbcSurface) {
  const auto field = fields::make_field("abc");
  constexpr double pi = 3.14159265358979323846;
  const SurfaceRequest request{
      field.get(), segment_seed({pi, pi, pi - 3}, {pi, pi, pi + 3}), 5, 0, false, {}};
  for (const char* integrator :
       {"hultquist:threshold=0.1,rip=1e-8", "hultquist:tolerance=5e-3,rip=1e-8",
        "adaptive-front:threshold=0.3,rip=1e-8"}) {
    const MeshQuality quality = measure_quality(integrate_surface(integrator, request).mesh);
    EXPECT_EQ(quality.sheets, 1u) << integrator;
    EXPECT_TRUE(quality.manifold) << integrator;
  }
  // With coarser seeds it is: the test can fail.
  EXPECT_GT(measure_quality(integrate_surface("hultquist:threshold=0.1", request).mesh).sheets, 1u);
}

TEST(UnitSurface, ClosedSeedsMakeTubes) {
  const auto field = fields::make_field("rotation:omega=1,c=1");
  for (const char* integrator : {"hultquist:threshold=0.05", "hultquist:tolerance=1e-3",
                                 "adaptive-front:particles=20,threshold=0.1", "fixed-front"}) {
    SurfaceRequest request{field.get(), circle_seed({1, 0, 0}, {0, 1, 0}, 0.3), 2, 0, false, {}};
    const MeshQuality quality = measure_quality(integrate_surface(integrator, request).mesh);
    EXPECT_EQ(quality.sheets, 1u) << integrator;
    EXPECT_TRUE(quality.manifold) << integrator;
    EXPECT_EQ(quality.duplicate_vertices, 0u) << integrator;
  }
}

TEST(UnitSurface, GhostNormalsAgreeWithVariationalOnes) {
  const auto field = fields::make_field("abc");
  SurfaceRequest request{
      field.get(), segment_seed({2.64, 3.14, 3.14}, {3.64, 3.14, 3.14}), 4, 0, false, {}};
  const auto normals = [&](const std::string& how) {
    return integrate_surface("fixed-front:particles=50,rows=50," + how, request).mesh.normals;
  };
  const auto truth = normals("normals=variational");
  for (const char* how : {"normals=ghost,ghost=reset", "normals=ghost,ghost=rescale"}) {
    const auto ghosts = normals(how);
    for (std::size_t i = 0; i < truth.size(); ++i)
      // Degrees. A ghost stands off by a small distance, whose second-order part is the angle.
      // Measured 9e-4; ten times that.
      ASSERT_LE(57.29577951 * std::asin(glm::length(glm::cross(truth[i], ghosts[i]))), 1e-2) << how;
  }
}

TEST(PropertyThreads, MeshesAreTheSameToTheLastBitForAnyNumberOfThreads) {
  const ClosedForm form = closed_forms()[0];
  for (const IntegratorRow& row : integrators()) {
    const geometry::TriangleMesh parallel = sweep(form, row.name).surface.mesh;
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const geometry::TriangleMesh serial = sweep(form, row.name).surface.mesh;
    EXPECT_EQ(parallel.positions, serial.positions) << row.name;
    EXPECT_EQ(parallel.normals, serial.normals) << row.name;
    EXPECT_EQ(parallel.triangles, serial.triangles) << row.name;
  }
}

TEST(AgreementSurface, MeasuredErrorIsThatOfTheClosedForm) {
  for (const ClosedForm& form : closed_forms()) {
    const auto swept = sweep(form, "fixed-front:particles=12,rows=12");
    const double exact = largest_distance(form, swept.surface.mesh);
    const double measured = measure_error(swept.surface.mesh, swept.request, 2000).max;
    // The measure knows where the surface ends; an implicit form goes on beyond the border.
    EXPECT_GE(measured, exact * 0.95) << form.name;
    EXPECT_LE(measured, exact * 3) << form.name;
  }
}

TEST(AgreementSurface, AbcWithoutCKeepsItsInvariants) {
  // With C = 0, H = B sin x + A cos z is kept, and y = y₀ + H t.
  const auto field = fields::make_field("abc:C=0");
  const double A = std::sqrt(3.), B = std::sqrt(2.);
  SurfaceRequest request{
      field.get(), segment_seed({2.64, 3.14, 3.14}, {3.64, 3.14, 3.3}), 4, 0, false, {}};
  const geometry::TriangleMesh mesh = integrate_surface("hultquist", request).mesh;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Vec3 seed = request.seed.point_at(mesh.scalars.at("s")[i]), x = mesh.positions[i];
    const double H = B * std::sin(seed.x) + A * std::cos(seed.z);
    EXPECT_NEAR(B * std::sin(x.x) + A * std::cos(x.z), H, testing::trajectory_error);
    EXPECT_NEAR(x.y, seed.y + H * mesh.scalars.at("t")[i], testing::trajectory_error);
  }
}

}  // namespace
}  // namespace pellucid::integrators
