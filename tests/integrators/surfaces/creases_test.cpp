// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces from seed curves with corners: there the normal turns at once along a crease, and no
// particle between two others would help. They stay whole, to the seam of a closed curve.
#include <gtest/gtest.h>

#include <cmath>

#include "fields/make_field.h"
#include "integrators/mesh/mesh_quality.h"
#include "integrators/surfaces/integrate_surface.h"
#include "integrators/surfaces/surface_error.h"
#include "tests/support/mesh_area.h"

namespace pellucid::integrators {
namespace {

const Vec3 square[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
const Vec3 hook[] = {{0, 0, 0}, {1, 0, 0}, {0, 0.3, 0}};

const char* const fronts[] = {"hultquist",
                              "hultquist:threshold=0.01",
                              "hultquist:tolerance=1e-3",
                              "hultquist:tolerance=1e-3,normals=ghost",
                              "adaptive-front",
                              "adaptive-front:tolerance=1e-3",
                              "adaptive-front:particles=5,threshold=0.1",
                              "fixed-front:particles=30,rows=7"};

IntegratedSurface sweep_corners(const std::string& velocity, std::string_view integrator,
                                const SeedCurve& seed, double duration) {
  const auto field = fields::make_field(velocity);
  return integrate_surface(integrator, {field.get(), seed, duration, 0, false, {}});
}

/// Vertices less edges plus triangles, whose 3 F sides are two of each edge but on the border:
/// 0 of a ring, 1 of a disc.
double euler_characteristic(const geometry::TriangleMesh& mesh, const MeshQuality& quality) {
  const auto vertices = double(mesh.positions.size()), facets = double(mesh.triangles.size());
  return vertices - 0.5 * facets - 0.5 * double(quality.boundary_edges);
}

TEST(UnitCreases, PrismsAreWholeToTheSeam) {
  for (const char* integrator : fronts)
    for (const bool closed : {true, false}) {
      const SeedCurve seed = closed ? polyline_seed(square, true) : polyline_seed(hook);
      const auto surface = sweep_corners("formula:u=0,v=0,w=1", integrator, seed, 1);
      const MeshQuality quality = measure_quality(surface.mesh);
      const double area = closed ? 4 : 1 + std::sqrt(1.09);
      EXPECT_NEAR(testing::area_of(surface.mesh), area, 1e-9) << integrator;
      EXPECT_EQ(surface.stats.trimmed, 0u) << integrator;
      EXPECT_EQ(quality.sheets, 1u) << integrator;
      EXPECT_TRUE(quality.manifold) << integrator;
      EXPECT_EQ(euler_characteristic(surface.mesh, quality), closed ? 0 : 1) << integrator;
    }
}

/// A crease has no normal of its own, but that of a prism lies evenly between its sides'.
TEST(UnitCreases, NormalsLieBetweenTheSides) {
  const auto surface = sweep_corners("formula:u=0,v=0,w=1", "fixed-front:particles=5,rows=1",
                                     polyline_seed(square, true), 1);
  const auto& s = surface.mesh.scalars.at("s");
  for (std::size_t i = 0; i < s.size(); ++i) {
    const Vec3& n = surface.mesh.normals[i];
    const bool crease = std::abs(4 * s[i] - std::round(4 * s[i])) < 1e-9;
    EXPECT_EQ(std::abs(n.x) > 0.2 && std::abs(n.y) > 0.2, crease) << s[i];
  }
}

TEST(PropertyCreases, TheToleranceHoldsBesideThemToo) {
  const Vec3 corners[] = {{3, 3, 1}, {3.6, 3, 1}, {3.6, 3.6, 1.2}, {3, 3.6, 1}};
  const auto field = fields::make_field("abc");
  for (const char* integrator :
       {"hultquist:tolerance=2e-3", "adaptive-front:particles=5,tolerance=2e-3"})
    for (const bool closed : {true, false}) {
      const SurfaceRequest request{field.get(), polyline_seed(corners, closed), 1, 0, false, {}};
      const auto surface = integrate_surface(integrator, request);
      const MeshQuality quality = measure_quality(surface.mesh);
      const SurfaceError error = measure_error(surface.mesh, request, 300);
      EXPECT_LE(error.max, 2e-3) << integrator;
      EXPECT_LE(error.max_from_surface, 2e-3) << integrator;
      EXPECT_LE(error.normal_max_degrees, 30) << integrator;
      EXPECT_EQ(quality.sheets, 1u) << integrator;
      EXPECT_EQ(euler_characteristic(surface.mesh, quality), closed ? 0 : 1) << integrator;
    }
}

}  // namespace
}  // namespace pellucid::integrators
