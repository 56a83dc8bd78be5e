// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/heat_distances.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "core/error.h"
#include "tests/support/woven_mesh.h"

namespace pellucid::geometry {
namespace {

using pellucid::testing::woven_mesh;

std::map<std::uint32_t, double> from(const TriangleMesh& surface, std::uint32_t triangle) {
  std::map<std::uint32_t, double> distances;
  for (const auto& [vertex, d] : HeatDistances(surface.positions, surface.triangles).from(triangle))
    distances[vertex] = d;
  return distances;
}

TEST(UnitHeatDistances, OnAPlaneAreThoseOfThePlane) {
  const TriangleMesh plane = woven_mesh(60, [](double x, double y) { return Vec3(x, y, 0); });
  const std::uint32_t middle = 2 * (30 * 60 + 30);
  const auto distances = from(plane, middle);
  ASSERT_EQ(distances.size(), plane.positions.size());
  const Vec3 center(0.5 + 2. / 180, 0.5 + 1. / 180, 0);
  for (const auto& [vertex, d] : distances) {
    const double expected = glm::distance(plane.positions[vertex], center);
    EXPECT_NEAR(d, expected, 0.03 * expected + 0.01) << vertex;  // 0.01: of a triangle, 0.02 long
  }
}

/// Rolled up to half a cylinder: the way over it is not the chord.
TEST(UnitHeatDistances, FollowASurfaceThatIsBent) {
  const TriangleMesh roll = woven_mesh(60, [](double x, double y) {
    return Vec3(std::cos(std::numbers::pi * x), std::sin(std::numbers::pi * x), y);
  });
  const auto distances = from(roll, 0);
  EXPECT_NEAR(distances.at(60), std::numbers::pi, 0.05 * std::numbers::pi);  // the chord is 2
  EXPECT_NEAR(distances.at(61 * 61 - 1), std::hypot(std::numbers::pi, 1), 0.05 * 3.3);
}

TEST(UnitHeatDistances, ReachThePieceAndNothingElse) {
  TriangleMesh two = woven_mesh(4, [](double x, double y) { return Vec3(x, y, 0); });
  const auto first = std::uint32_t(two.positions.size());
  for (const Vec3& x : {Vec3(5, 0, 0), Vec3(6, 0, 0), Vec3(5, 3, 0)}) two.positions.push_back(x);
  two.triangles.push_back({first, first + 1, first + 2});
  EXPECT_EQ(from(two, 3).size(), 25u);
  const auto alone = from(two, std::uint32_t(two.triangles.size()) - 1);
  ASSERT_EQ(alone.size(), 3u);
  EXPECT_DOUBLE_EQ(alone.at(first + 1), std::hypot(2. / 3, 1));
}

TEST(UnitHeatDistances, ATriangleWithoutAnAreaIsRefused) {
  TriangleMesh flat = woven_mesh(2, [](double x, double y) { return Vec3(x, y, 0); });
  flat.positions[4] = flat.positions[0];
  EXPECT_THROW(HeatDistances(flat.positions, flat.triangles), InputError);
}

}  // namespace
}  // namespace pellucid::geometry
