// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/methods/tree/mesh_opacity.h"

#include <gtest/gtest.h>

#include <random>

namespace pellucid::oit {
namespace {

/// n × m quads over s and t in [0, 1] × [0, T], each vertex of the opacity that `of` gives its
/// place; over the seam of a closed one the last column's vertices are the first's.
template <class Of>
geometry::TriangleMesh mesh_over(std::uint32_t n, std::uint32_t m, double T, bool closed, Of of) {
  geometry::TriangleMesh mesh;
  const std::uint32_t columns = closed ? n : n + 1;
  for (std::uint32_t y = 0; y <= m; ++y)
    for (std::uint32_t x = 0; x < columns; ++x) {
      const double s = double(x) / n, t = T * y / m;
      mesh.positions.emplace_back(s, t, 0);
      mesh.scalars["s"].push_back(s);
      mesh.scalars["t"].push_back(t);
      mesh.colors.emplace_back(0, 0, 0, of(s, t));
    }
  for (std::uint32_t y = 0; y < m; ++y)
    for (std::uint32_t x = 0; x < n; ++x) {
      const std::uint32_t a = y * columns + x, b = y * columns + (x + 1) % columns;
      mesh.triangles.push_back({a, b, b + columns});
      mesh.triangles.push_back({a, b + columns, a + columns});
    }
  return mesh;
}

/// As far as float opacities tell.
constexpr double float_opacity = 1e-6;

// Linear in s and t, it is itself between the vertices, too: of cells longer than wide and the
// other way round, and of a surface against time.
TEST(UnitMeshOpacity, LinearOnesAreInterpolatedExactly) {
  const auto of = [](double s, double t) { return 0.1 + 0.3 * s + 0.2 * t; };
  std::mt19937 random(41);
  std::uniform_real_distribution<double> unit(0, 1);
  for (const auto& [n, m] : {std::pair(1u, 1u), std::pair(3u, 50u), std::pair(70u, 2u)}) {
    geometry::TriangleMesh mesh = mesh_over(n, m, 2, false, of);
    for (const double direction : {1., -1.}) {
      for (double& t : mesh.scalars["t"]) t = direction * std::abs(t);
      const MeshOpacity opacity(mesh, false);
      for (int i = 0; i < 500; ++i) {
        const double s = unit(random), t = 2 * unit(random);
        EXPECT_NEAR(opacity.at(s, direction * t), of(s, t), float_opacity) << s << ' ' << t;
      }
      EXPECT_GT(opacity.bytes(), 0u);
    }
  }
}

// The last column of quads joins s = 3/4 and s = 0: half way between them is half of each.
TEST(UnitMeshOpacity, TheSeamOfAClosedCurveIsCrossed) {
  const auto of = [](double s, double) { return s == 0 ? 0.2 : s == 0.75 ? 0.6 : 1; };
  const MeshOpacity opacity(mesh_over(4, 3, 1, true, of), true);
  EXPECT_NEAR(opacity.at(0.875, 0.4), 0.4, float_opacity);
  EXPECT_NEAR(opacity.at(0.999999, 0.4), 0.2, 1e-5);
  EXPECT_NEAR(opacity.at(0, 0.4), 0.2, float_opacity);
  EXPECT_NEAR(opacity.at(0.125, 0.4), 0.6, float_opacity);
}

// Corners may lie on both sides of the seam, none on it.
TEST(UnitMeshOpacity, WhatReachesOverTheSeamIsOnBothOfItsSides) {
  geometry::TriangleMesh mesh = mesh_over(4, 2, 1, true, [](double s, double) { return s / 2; });
  for (double& s : mesh.scalars["s"]) s += 0.125;  // from 1/8 to 7/8, opacities from 0 to 3/8
  const MeshOpacity opacity(mesh, true);
  EXPECT_NEAR(opacity.at(0.125 / 2, 0.3), 0.375 / 4, float_opacity);
  EXPECT_NEAR(opacity.at(1 - 0.125 / 2, 0.3), 0.375 * 3 / 4, float_opacity);
}

// Of a mesh without its middle third in s, it is that of the nearer rim, and beyond its end that of
// the end.
TEST(UnitMeshOpacity, BesideTheMeshItIsTheNearest) {
  geometry::TriangleMesh mesh = mesh_over(30, 30, 1, false, [](double s, double) { return s; });
  std::erase_if(mesh.triangles, [&](const auto& corners) {
    const auto& s = mesh.scalars["s"];
    const double middle = (s[corners[0]] + s[corners[1]] + s[corners[2]]) / 3;
    return middle > 1.0 / 3 && middle < 2.0 / 3;
  });
  const MeshOpacity opacity(mesh, false);
  EXPECT_NEAR(opacity.at(0.45, 0.51), 1.0 / 3, float_opacity);
  EXPECT_NEAR(opacity.at(0.55, 0.51), 2.0 / 3, float_opacity);
  EXPECT_NEAR(opacity.at(0.2, 1.7), 0.2, float_opacity);
}

}  // namespace
}  // namespace pellucid::oit
