// SPDX-License-Identifier: GPL-3.0-or-later
// Means over a mesh's samples against integrals in closed form.
#include "integrators/mesh/mesh_samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "integrators/mesh/mesh_distance.h"
#include "integrators/surfaces/integrate_surface.h"
#include "integrators/surfaces/surface_error.h"
#include "tests/integrators/test_fields.h"

namespace pellucid::integrators {
namespace {

/// A prism of n sides and height 1 in the cylinder of radius 1.
geometry::TriangleMesh prism(std::uint32_t n) {
  geometry::TriangleMesh mesh;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    for (const double z : {0., 1.})
      mesh.positions.emplace_back(std::cos(angle), std::sin(angle), z);
    const std::uint32_t a = 2 * i, b = 2 * ((i + 1) % n);
    mesh.triangles.push_back({a, b, a + 1});
    mesh.triangles.push_back({a + 1, b, b + 1});
  }
  return mesh;
}

/// Of a prism's sides from the cylinder: at x beside a side's middle, in a side of half width a at
/// distance h from the axis, it is 1 - √(h² + x²).
OneSidedDistance exact_distance(double n) {
  const double a = std::sin(std::numbers::pi / n), h = std::cos(std::numbers::pi / n);
  // ∫₀ᵃ √(h² + x²) dx / a, with √(h² + a²) = 1, and ∫₀ᵃ (h² + x²) dx / a.
  const double radius = 0.5 * (1 + h * h / a * std::asinh(a / h)), square = h * h + a * a / 3;
  return {1 - radius, std::sqrt(1 - 2 * radius + square), 1 - h};
}

template <class Distance>
void expect_exact(const Distance& found, std::uint32_t n, double part) {
  const OneSidedDistance exact = exact_distance(n);
  EXPECT_NEAR(found.mean, exact.mean, part * exact.mean) << n;
  EXPECT_NEAR(found.rms, exact.rms, part * exact.rms) << n;
  EXPECT_NEAR(found.max, exact.max, 1e-3 * exact.max) << n;
}

TEST(PropertyMeshSamples, MeansOfAPrismAreItsIntegrals) {
  for (const std::uint32_t n : {3u, 6u, 24u, 100u})
    for (const std::uint64_t samples : {100u, 1000u, 10000u}) {
      const geometry::TriangleMesh mesh = prism(n);
      OneSidedDistance found;
      double weights = 0;
      for (const MeshSample& sample : sample_mesh(mesh, samples)) {
        const Vec3 x = position_of(mesh, sample);
        const double distance = 1 - std::hypot(x.x, x.y);
        weights += sample.weight;
        found.mean += sample.weight * distance;
        found.rms += sample.weight * distance * distance;
        found.max = std::max(found.max, distance);
      }
      found.rms = std::sqrt(found.rms);
      EXPECT_NEAR(weights, 1, 1e-12);
      // Evenly covered: errors fall as one over the number. Measured up to 9 / samples, where a
      // triangle has two; the four places alone would be off by 13 to 40 %.
      expect_exact(found, n, 12. / double(samples));
    }
}

TEST(PropertyMeshSamples, EveryTriangleHasItsShareWhateverItsSize) {
  // One triangle of a thousand times the others' area.
  geometry::TriangleMesh mesh = prism(50);
  const auto base = std::uint32_t(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), {{0, 0, 5}, {10, 0, 5}, {0, 10, 5}});
  mesh.triangles.push_back({base, base + 1, base + 2});
  double share = 0;
  for (const MeshSample& sample : sample_mesh(mesh, 2000))
    if (sample.triangle + 1 == mesh.triangles.size()) share += sample.weight;
  const double sides = 50 * 2 * std::sin(std::numbers::pi / 50);
  EXPECT_NEAR(share, 50 / (50 + sides), 1. / 2000);
}

/// A unit square in rows of ten squares, as fronts make them.
geometry::TriangleMesh rows_of_ten(std::uint32_t rows) {
  constexpr std::uint32_t columns = 10;
  geometry::TriangleMesh mesh;
  for (std::uint32_t j = 0; j <= rows; ++j)
    for (std::uint32_t i = 0; i <= columns; ++i)
      mesh.positions.emplace_back(i / double(columns), j / double(rows), 0);
  for (std::uint32_t j = 0; j < rows; ++j)
    for (std::uint32_t i = 0; i < columns; ++i) {
      const std::uint32_t a = j * (columns + 1) + i, c = a + columns + 1;
      mesh.triangles.push_back({a, a + 1, c});
      mesh.triangles.push_back({c, a + 1, c + 1});
    }
  return mesh;
}

TEST(PropertyMeshSamples, NoNumberOfRowsIsInStepWithThem) {
  constexpr std::uint64_t samples = 500;
  // Fibonacci's numbers are those that steps of the golden ratio fall in with.
  for (const std::uint32_t rows : {50u, 100u, 200u, 233u, 250u, 377u, 500u, 610u, 987u, 1000u}) {
    const geometry::TriangleMesh mesh = rows_of_ten(rows);
    double right = 0;  // the share of x > 0.9: a tenth
    for (const MeshSample& sample : sample_mesh(mesh, samples))
      if (position_of(mesh, sample).x > 0.9) right += sample.weight;
    // By lot alone σ = √(0.1 · 0.9 / 500) = 0.013, of which 4 are allowed.
    EXPECT_NEAR(right, 0.1, 0.053) << rows;
  }
}

TEST(AgreementMeshSamples, DistancesOfMeshesAreTheIntegrals) {
  // The finer prism's own distance is (8 / 2000)² of the coarser one's.
  expect_exact(mesh_distance(prism(8), prism(2000), 4000).from_first, 8, 5e-3);
}

TEST(AgreementMeshSamples, TheErrorOfASurfaceIsTheIntegral) {
  const auto up = testing::everywhere([](const Vec3&) { return Vec3(0, 0, 1); });
  const SurfaceRequest request{&up, circle_seed({0, 0, 0}, {0, 0, 1}, 1), 1, 0, false, {}};
  const auto surface = integrate_surface("fixed-front:particles=8,rows=1", request);
  expect_exact(measure_error(surface.mesh, request, 4000), 8, 5e-3);
}

TEST(AgreementMeshSamples, NormalsOfADiscAreItsOwn) {
  // About the axis the two sides of the seed curve go opposite ways; all facets lie in the plane,
  // and but for those of the one column of 499 that reaches over the axis they face as the surface
  // does there. That column has less than a thousandth of the area: a mean of 180° / 500 at most.
  const auto turn = testing::everywhere([](const Vec3& x) { return Vec3(-x.y, x.x, 0); });
  const SurfaceRequest request{&turn, segment_seed({-1, 0, 0}, {2, 0, 0}), 3, 0, false, {}};
  const auto surface = integrate_surface("fixed-front", request);
  EXPECT_LE(measure_error(surface.mesh, request, 500).normal_mean_degrees, 0.4);
}

}  // namespace
}  // namespace pellucid::integrators