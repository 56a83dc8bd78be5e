// SPDX-License-Identifier: GPL-3.0-or-later
// Distances between meshes against what geometry says they are.
#include "integrators/mesh/mesh_distance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "tests/integrators/closed_forms.h"

namespace pellucid::integrators {
namespace {

/// n x n squares over [0, width]², cut in two, at this height.
geometry::TriangleMesh square(double width, double height, std::uint32_t n) {
  geometry::TriangleMesh mesh;
  for (std::uint32_t j = 0; j <= n; ++j)
    for (std::uint32_t i = 0; i <= n; ++i)
      mesh.positions.emplace_back(width * i / n, width * j / n, height);
  for (std::uint32_t j = 0; j < n; ++j)
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = j * (n + 1) + i, b = a + 1, c = a + n + 1, d = c + 1;
      mesh.triangles.push_back({a, b, d});
      mesh.triangles.push_back({a, d, c});
    }
  return mesh;
}

TEST(UnitMeshDistance, ParallelSquaresAreAsFarApartAsTheirPlanes) {
  const auto [from_first, from_second] = mesh_distance(square(1, 0, 3), square(1, 0.25, 5), 1000);
  for (const OneSidedDistance& distance : {from_first, from_second}) {
    // A thousand samples' sum rounds by 1.1e-16 of itself each time; the distances themselves are
    // exact.
    EXPECT_NEAR(distance.mean, 0.25, 1e-14);
    EXPECT_NEAR(distance.rms, 0.25, 1e-14);
    EXPECT_NEAR(distance.max, 0.25, 1e-14);
  }
}

/// Powers of two change no digit.
TEST(UnitMeshDistance, UnitsDoNotMatter) {
  const auto distances = [](double unit) {
    const auto [first, second] = mesh_distance(square(unit, 0, 3), square(unit, unit / 4, 5), 100);
    const Vec3 above(unit / 2, unit / 2, 3 * unit);
    return std::vector{first.mean,  first.rms,  first.max,
                       second.mean, second.rms, largest_distance({{above}}, square(unit, 0, 2))};
  };
  const std::vector<double> wanted = distances(1);
  EXPECT_EQ(wanted.back(), 3);
  for (const double unit : {0x1p-400, 0x1p+400}) {
    const std::vector<double> found = distances(unit);
    for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_EQ(found[i] / unit, wanted[i]) << i;
  }
}

TEST(UnitMeshDistance, WhatOneMeshLacksShowsFromTheOther) {
  constexpr std::uint32_t n = 64;
  const geometry::TriangleMesh part = square(0.5, 0, n), whole = square(1, 0, n);
  const auto [from_part, from_whole] = mesh_distance(part, whole, 1 << 16);
  // Samples are mixtures of three corners in one plane, at z = 0, which every sum keeps.
  EXPECT_LE(from_part.max, 1e-15);
  // Over the strips right of and above the part d is its distance to the edge, over the corner to
  // the corner: ∫ d dA = 2 · 1/2 · 1/8 + (1/2)³ (√2 + asinh 1) / 3.
  const double mean = 0.125 + (std::sqrt(2.) + std::asinh(1.)) / 24;
  EXPECT_NEAR(from_whole.mean, mean, mean * 1e-3);
  // The outermost samples are the middles of sides, half a square from the whole's corner.
  EXPECT_NEAR(from_whole.max, std::sqrt(0.5), 1. / n);
}

TEST(UnitMeshDistance, AMeshWithoutAreaIsRefused) {
  geometry::TriangleMesh line;
  line.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  line.triangles = {{0, 1, 2}};
  EXPECT_THROW(mesh_distance(line, square(1, 0, 1), 10), InputError);
  EXPECT_THROW(mesh_distance(square(1, 0, 1), line, 10), InputError);
}

TEST(AgreementSurface, DistanceToAFinerRunIsThatToTheExactSurface) {
  for (const testing::ClosedForm& form : testing::closed_forms()) {
    const geometry::TriangleMesh coarse =
        testing::sweep(form, "hultquist:tolerance=1e-2").surface.mesh;
    const geometry::TriangleMesh fine =
        testing::sweep(form, "hultquist:tolerance=1e-4").surface.mesh;
    const auto [from_coarse, from_fine] = mesh_distance(coarse, fine, 1 << 16);
    const double exact = testing::largest_distance(form, coarse);
    // The finer run is off by at most its tolerance. Both end at the same border, which the
    // implicit form does not know: there the distance may be larger, by the border's sagitta.
    EXPECT_GE(from_coarse.max, exact - 1e-4) << form.name;
    EXPECT_LE(from_coarse.max, 1e-2) << form.name;
    EXPECT_LE(from_fine.max, 1e-2) << form.name;
  }
}

}  // namespace
}  // namespace pellucid::integrators
