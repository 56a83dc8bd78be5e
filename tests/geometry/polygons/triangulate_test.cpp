// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/polygons/triangulate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "core/vec.h"

namespace pellucid::geometry {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

std::vector<std::uint32_t> in_order(std::size_t count) {
  std::vector<std::uint32_t> corners(count);
  std::iota(corners.begin(), corners.end(), 0u);
  return corners;
}

Triangles triangles_of(const std::vector<Vec3>& polygon) {
  Triangles triangles;
  triangulate_polygon(polygon, in_order(polygon.size()), triangles);
  return triangles;
}

Triangles fan_of(std::uint32_t corners) {
  Triangles fan;
  for (std::uint32_t k = 2; k < corners; ++k) fan.push_back({0, k - 1, k});
  return fan;
}

/// n - 2 triangles, none of which turns against the polygon, whose areas add up to the polygon's.
/// Each area is rounded by a few ulps of the squared extent: n times that, with a margin of 8, and
/// as much more as the polygon lies off the origin.
void expect_cover(const std::vector<Vec3>& polygon, double rounding = 0x1p-49) {
  const Triangles triangles = triangles_of(polygon);
  ASSERT_EQ(triangles.size(), polygon.size() - 2);
  Box3 box;
  for (const Vec3& x : polygon) box.extend(x);
  const double unit = box.diagonal() * box.diagonal();
  const Vec3 whole = newell_area(polygon, in_order(polygon.size()));
  const Vec3 normal = whole / glm::length(whole);
  double sum = 0;
  for (const auto& [a, b, c] : triangles) {
    const double area =
        0.5 * glm::dot(normal, glm::cross(polygon[b] - polygon[a], polygon[c] - polygon[a]));
    EXPECT_GE(area, -rounding * unit);
    sum += std::abs(area);
  }
  EXPECT_NEAR(sum, glm::length(whole), rounding * unit * double(polygon.size()));
}

using Outline = std::vector<Vec2>;

/// Around the origin, at random distances.
Outline star(std::mt19937& random, int n) {
  std::uniform_real_distribution<double> radius(0.05, 1);
  Outline outline;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    outline.push_back(radius(random) * Vec2(std::cos(angle), std::sin(angle)));
  }
  return outline;
}

/// Teeth of random lengths on a bar.
Outline comb(std::mt19937& random, int n) {
  std::uniform_real_distribution<double> length(0.5, 5);
  Outline outline{{double(n), -1}, {double(n), 0}};
  for (int i = n; i-- > 0;) {
    outline.emplace_back(i + 0.5, length(random));
    outline.emplace_back(i, 0);
  }
  outline.emplace_back(0, -1);
  return outline;
}

/// A band that winds inwards and back.
Outline spiral(std::mt19937& random, int n) {
  std::uniform_real_distribution<double> wiggle(-0.1, 0.1);
  Outline outline;
  const auto at = [&](int i, double offset) {
    const double angle = 0.3 * i, radius = 1 + angle / (2 * std::numbers::pi) + offset;
    outline.push_back((radius + wiggle(random)) * Vec2(std::cos(angle), std::sin(angle)));
  };
  for (int i = 0; i < n; ++i) at(i, 0.3);
  for (int i = n; i-- > 0;) at(i, -0.1);
  return outline;
}

/// Every edge has up to three corners more on it, the last of them at its end once more.
Outline with_straight_corners(std::mt19937& random, const Outline& outline) {
  Outline more;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 a = outline[i], b = outline[(i + 1) % outline.size()];
    const auto parts = random() % 4;
    more.push_back(a);
    for (unsigned k = 1; k <= parts; ++k) more.push_back(a + (b - a) * (double(k) / parts));
  }
  return more;
}

/// Into space: turned at random, scaled, from a random corner on, either way around.
std::vector<Vec3> placed(std::mt19937& random, Outline outline, double scale) {
  std::normal_distribution<double> normal;
  const auto direction = [&] {
    return glm::normalize(Vec3(normal(random), normal(random), normal(random)));
  };
  const Vec3 u = direction(), v = glm::normalize(glm::cross(u, direction()));
  std::rotate(outline.begin(), outline.begin() + long(random() % outline.size()), outline.end());
  if (random() % 2) std::reverse(outline.begin(), outline.end());
  std::vector<Vec3> polygon;
  for (const Vec2& x : outline) polygon.push_back(scale * (x.x * u + x.y * v));
  return polygon;
}

class PropertyPolygons : public ::testing::TestWithParam<Outline (*)(std::mt19937& random, int n)> {
};

TEST_P(PropertyPolygons, TrianglesCoverThemOnce) {
  std::mt19937 random(7);
  for (int round = 0; round < 300; ++round) {
    const double scale = std::pow(10.0, round % 21 - 10);
    const Outline outline = GetParam()(random, 3 + round % 60);
    expect_cover(placed(random, outline, scale));
    expect_cover(placed(random, with_straight_corners(random, outline), scale));
  }
}

// A float's rounding puts straight corners off their lines, and the plane off flatness.
TEST_P(PropertyPolygons, SoTheyDoRoundedToFloats) {
  std::mt19937 random(8);
  for (int round = 0; round < 300; ++round) {
    const Outline outline = GetParam()(random, 3 + round % 60);
    std::vector<Vec3> polygon = placed(random, with_straight_corners(random, outline), 1);
    for (Vec3& x : polygon) x = Vec3(glm::vec3(x));
    expect_cover(polygon, 0x1p-22);
  }
}

INSTANTIATE_TEST_SUITE_P(Outlines, PropertyPolygons, ::testing::Values(star, comb, spiral));

TEST(UnitPolygons, TheLCoversFiveSquaresOfNine) {
  // The corner (0, 0) sees all of it; from (3, 0) on, the fan leaves it.
  const Outline l{{3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}, {0, 0}};
  std::vector<Vec3> polygon;
  for (const Vec2& x : l) polygon.emplace_back(x.x, x.y, 0);
  expect_cover(polygon);
  EXPECT_NEAR(glm::length(newell_area(polygon, in_order(6))), 5, 1e-14);
  EXPECT_NE(triangles_of(polygon), fan_of(6));
}

TEST(PropertyPolygons, ConvexOnesStayFans) {
  std::mt19937 random(9);
  for (int n = 3; n < 40; ++n) {
    Outline circle;
    for (int i = 0; i < n; ++i)
      circle.emplace_back(std::cos(2 * std::numbers::pi * i / n),
                          std::sin(6.283185307179586 * i / n));
    EXPECT_EQ(triangles_of(placed(random, circle, std::pow(10.0, n - 20))),
              fan_of(std::uint32_t(n)));
  }
}

// A hole is joined to the outline by an edge that runs there and back.
TEST(UnitPolygons, AHoleAtTheEndOfABridgeStaysOpen) {
  const std::vector<Vec3> polygon{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0},
                                  {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}, {1, 1, 0}};
  expect_cover(polygon);
  EXPECT_NEAR(glm::length(newell_area(polygon, in_order(10))), 12, 1e-14);
}

TEST(UnitPolygons, TwoSquaresThatShareACornerAreBothCovered) {
  expect_cover(
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {1, 1, 0}, {0, 1, 0}});
}

TEST(UnitPolygons, OneThatCrossesItselfBecomesTheFan) {
  EXPECT_EQ(triangles_of({{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 1, 0}}), fan_of(4));
}

TEST(UnitPolygons, WithoutAPlaneItIsTheFan) {
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(triangles_of({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}), fan_of(4));
  EXPECT_EQ(triangles_of(std::vector<Vec3>(5, Vec3(1))), fan_of(5));
  EXPECT_EQ(triangles_of({{0, 0, 0}, {1, 0, 0}, {inf, 1, 0}, {0, 1, 0}}), fan_of(4));
  EXPECT_EQ(triangles_of({{-1e308, 0, 0}, {1e308, 0, 0}, {0, 0.1, 0}, {0, 1e308, 0}}).size(), 2u);
  EXPECT_TRUE(triangles_of({{0, 0, 0}, {1, 0, 0}}).empty());
}

// 50 000 corners, half of which every ear would be held against: 1e9 tests and more, many seconds.
TEST(UnitPolygons, ManyCornersTakeNoSquareOfTheirTime) {
  std::mt19937 random(10);
  EXPECT_EQ(triangles_of(placed(random, star(random, 50000), 1)).size(), 49998u);
}

}  // namespace
}  // namespace pellucid::geometry
