// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/queries/ray_query.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "core/error.h"

namespace pellucid::groundtruth {
namespace {

using geometry::TriangleMesh;

/// The cube [0, n]³ of n³ cells, each face of a cell two triangles, faces outwards.
TriangleMesh cube(int n) {
  TriangleMesh mesh;
  for (int axis = 0; axis < 3; ++axis)
    for (const int side : {0, n})
      for (int i = 0; i < n; ++i)
        for (int k = 0; k < n; ++k) {
          const auto first = std::uint32_t(mesh.positions.size());
          for (const auto& [p, q] : {std::pair(i, k), {i + 1, k}, {i + 1, k + 1}, {i, k + 1}}) {
            Vec3 x;
            x[axis] = side;
            x[(axis + 1) % 3] = p;
            x[(axis + 2) % 3] = q;
            mesh.positions.push_back(x);
          }
          const bool outwards = side == n;
          mesh.triangles.push_back({first, first + (outwards ? 1 : 2), first + (outwards ? 2 : 1)});
          mesh.triangles.push_back({first, first + (outwards ? 2 : 3), first + (outwards ? 3 : 2)});
        }
  return mesh;
}

TEST(UnitRayQuery, ACrossingIsWhereItIsKnownToBe) {
  TriangleMesh mesh;
  mesh.positions = {Vec3(0, 0, 2), Vec3(4, 0, 2), Vec3(0, 4, 2)};
  mesh.triangles = {{0, 1, 2}};
  const auto hits = RayQuery(mesh).all({Vec3(1, 0.5, 0), Vec3(0, 0, 0.5)});
  ASSERT_EQ(hits.size(), 1u);
  EXPECT_EQ(hits[0].t, 4);
  EXPECT_EQ(hits[0].u, 0.25);
  EXPECT_EQ(hits[0].v, 0.125);
  EXPECT_EQ(hits[0].side, 1);
  EXPECT_EQ(RayQuery(mesh).all({Vec3(1, 0.5, 4), Vec3(0, 0, -1)}).at(0).side, -1);
  EXPECT_EQ(RayQuery(mesh).count({Vec3(1, 0.5, 4), Vec3(0, 0, 1)}), 0u);  // behind the origin
}

TEST(UnitRayQuery, ARayThatBeginsOnATriangleCrossesItInOneDirection) {
  TriangleMesh mesh;
  mesh.positions = {Vec3(0, 0, 2), Vec3(4, 0, 2), Vec3(0, 4, 2)};
  mesh.triangles = {{0, 1, 2}};
  std::vector<RayHit> hits = RayQuery(mesh).all({Vec3(0, 0, 2), Vec3(0, 0, 1)});
  for (const RayHit& hit : RayQuery(mesh).all({Vec3(0, 0, 2), Vec3(0, 0, -1)})) hits.push_back(hit);
  ASSERT_EQ(hits.size(), 1u);
  for (const double zero : {hits[0].t, hits[0].u, hits[0].v}) {
    EXPECT_EQ(zero, 0);
    EXPECT_FALSE(std::signbit(zero));
  }
}

/// Powers of two change no digit, but products leave the range of doubles from 2^±342 on.
TEST(PropertyRayQuery, AMeshOfAnySizeIsCrossedInTheSamePlaces) {
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  const FreeRay ray{Vec3(-1, 0.2, 0.3), Vec3(1, 0.01, -0.02)};
  const std::vector<RayHit> expected = RayQuery(mesh).all(ray);
  ASSERT_EQ(expected.size(), 2u);
  for (const int exponent : {-1000, -700, -660, -345, -340, -250, 250, 338, 345, 660, 990})
    for (const bool unit_direction : {false, true}) {
      const double scale = std::ldexp(1.0, exponent);
      TriangleMesh scaled = mesh;
      for (Vec3& x : scaled.positions) x *= scale;
      const double length = unit_direction ? 1 : scale;
      const auto hits = RayQuery(scaled).all({scale * ray.origin, length * ray.direction});
      ASSERT_EQ(hits.size(), 2u) << exponent;
      for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(hits[i].triangle, expected[i].triangle);
        // Exact or by the filter: some ulps between them. Coordinates are all normal numbers.
        const double t = hits[i].t * (unit_direction ? 1 / scale : 1);
        EXPECT_NEAR(t, expected[i].t, 1e-14) << exponent;
        EXPECT_NEAR(hits[i].u, expected[i].u, 1e-14) << exponent;
        EXPECT_NEAR(hits[i].v, expected[i].v, 1e-14) << exponent;
      }
    }
}

TEST(PropertyRayQuery, TrianglesOfOnePlaneAreMetAtOneTInTheirOrder) {
  // z = x / 2 + y / 4, cut in two ways, and each triangle again with its corners numbered
  // otherwise.
  TriangleMesh mesh;
  for (const auto& [x, y] : {std::pair(-2., -2.), {2., -2.}, {2., 2.}, {-2., 2.}})
    mesh.positions.push_back({x, y, x / 2 + y / 4});
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 3, 0}, {3, 1, 2}, {2, 0, 1}, {3, 2, 0}, {0, 3, 1}};
  const RayQuery query(mesh);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < 500; ++i) {
    const Vec3 target(uniform(random), uniform(random), 0), origin(uniform(random), 2, 5);
    const FreeRay ray{origin, target - origin};
    const std::vector<RayHit> hits = query.all(ray);
    ASSERT_GE(hits.size(), 3u);
    for (std::size_t k = 0; k < hits.size(); ++k) {
      EXPECT_EQ(hits[k].t, hits[0].t);
      EXPECT_TRUE(k == 0 || hits[k - 1].triangle < hits[k].triangle);
    }
    EXPECT_EQ(query.first(ray)->triangle, hits[0].triangle);
  }
}

TEST(UnitRayQuery, ACrossingFurtherThanNumbersReachIsRefused) {
  TriangleMesh mesh;
  mesh.positions = {Vec3(-1e299, -1e299, 1e200), Vec3(1e299, 0, 1e200), Vec3(0, 1e299, 1e200)};
  mesh.triangles = {{0, 1, 2}};
  EXPECT_EQ(RayQuery(mesh).all({Vec3(0), Vec3(0, 0, 1)}).at(0).t, 1e200);
  EXPECT_THROW(RayQuery(mesh).all({Vec3(0), Vec3(0, 0, 1e-200)}), InputError);
}

/// Rays through lattice points run through vertices, along edges and within faces.
TEST(PropertyRayQuery, RaysThroughEdgesAndVerticesOfACubeCrossItTwice) {
  const RayQuery query(cube(3));
  std::mt19937 random(3);
  std::uniform_int_distribution<int> lattice(-2, 5);
  int through = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vec3 target(1 + lattice(random) % 2, 1, 2);  // inside
    const Vec3 origin = target + 7.0 * Vec3(lattice(random), lattice(random), lattice(random));
    if (origin == target) continue;
    const std::size_t count = query.count({origin, target - origin});
    through += count == 2;
    ASSERT_EQ(count % 2, query.inside(origin) ? 1u : 0u) << i;
    ASSERT_LE(count, 2u) << i;  // convex
  }
  EXPECT_GT(through, 2000);
}

TEST(PropertyRayQuery, InsideIsWhatTheCubesInequalitiesSay) {
  const RayQuery query(cube(2));
  for (int x = -1; x <= 9; ++x)
    for (int y = -1; y <= 9; ++y)
      for (int z = -1; z <= 9; ++z) {
        const Vec3 p = Vec3(x, y, z) / 4.0;  // on edges and diagonals of faces seen along z, too
        const auto within = [](double c) { return c > 0 && c < 2; };
        const auto outside = [](double c) { return c < 0 || c > 2; };
        if (within(p.x) && within(p.y) && within(p.z)) {
          EXPECT_TRUE(query.inside(p)) << x << y << z;
        }
        if (outside(p.x) || outside(p.y) || outside(p.z)) {
          EXPECT_FALSE(query.inside(p)) << x << y << z;
        }
      }
}

/// A point of the surface lies on one side of it, whichever way one looks.
TEST(PropertyRayQuery, PointsOfTheSurfaceHaveOneSide) {
  const RayQuery query(cube(2));
  std::mt19937 random(5);
  std::uniform_int_distribution<int> lattice(-3, 3), corner(0, 2);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 origin(corner(random), corner(random), corner(random));
    const Vec3 direction(lattice(random), lattice(random), lattice(random));
    if (direction == Vec3(0)) continue;
    ASSERT_EQ(query.count({origin, direction}) % 2, query.inside(origin) ? 1u : 0u) << i;
  }
}

/// The fan around a vertex: every ray into it crosses exactly one of its triangles.
TEST(PropertyRayQuery, AFanIsCrossedOnce) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < 500; ++i) {
    TriangleMesh fan;
    fan.positions.push_back(Vec3(uniform(random), uniform(random), uniform(random)) / 8.0);
    constexpr int blades = 7;
    for (int k = 0; k < blades; ++k) {
      const double angle = 2 * M_PI * k / blades;
      fan.positions.emplace_back(std::cos(angle), std::sin(angle), 0.3 * uniform(random));
      fan.triangles.push_back({0, std::uint32_t(1 + k), std::uint32_t(1 + (k + 1) % blades)});
    }
    const RayQuery query(fan);
    const Vec3 origin(uniform(random) / 4, uniform(random) / 4, -5);
    const auto edge = std::size_t(1 + i % blades);
    // Through the middle vertex, and through a point of a spoke as near as double has one.
    EXPECT_EQ(query.count({origin, fan.positions[0] - origin}), 1u) << i;
    const Vec3 spoke = 0.5 * fan.positions[0] + 0.5 * fan.positions[edge];
    EXPECT_EQ(query.count({origin, spoke - origin}), 1u) << i;
  }
}

TEST(PropertyRayQuery, TheFirstIsTheFirstOfAllAndAllIsWhatBruteForceFinds) {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> uniform(-1, 1);
  TriangleMesh soup;
  const auto point = [&] { return Vec3(uniform(random), uniform(random), uniform(random)); };
  for (std::uint32_t t = 0; t < 300; ++t) {
    for (int k = 0; k < 3; ++k) soup.positions.push_back(point());
    soup.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  const RayQuery query(soup);
  std::size_t crossings = 0;
  for (int i = 0; i < 300; ++i) {
    FreeRay ray{2.0 * point(), point()};
    if (i % 3 == 0) ray.direction[i % 9 / 3] = 0;
    std::vector<std::uint32_t> expected, found;
    for (const auto& [a, b, c] : soup.triangles)
      if (cross(ray, soup.positions[a], soup.positions[b], soup.positions[c]))
        expected.push_back(a / 3);
    const auto hits = query.all(ray);
    for (const RayHit& hit : hits) found.push_back(hit.triangle);
    EXPECT_THAT(found, ::testing::UnorderedElementsAreArray(expected));
    EXPECT_TRUE(std::is_sorted(hits.begin(), hits.end()));
    const auto first = query.first(ray);
    ASSERT_EQ(first.has_value(), !hits.empty());
    if (first) {
      EXPECT_EQ(first->triangle, hits[0].triangle);
    }
    crossings += hits.size();
  }
  EXPECT_GT(crossings, 500u);
}

/// Scaled by powers of two nothing changes but t; moved far away nothing overflows.
TEST(PropertyRayQuery, ScaleDoesNotMatter) {
  for (const double scale : {0x1p-300, 0x1p-40, 0x1p40, 0x1p300}) {
    TriangleMesh mesh = cube(2);
    for (Vec3& x : mesh.positions) x *= scale;
    const RayQuery query(mesh);
    EXPECT_EQ(query.count({scale * Vec3(-5, 1, 1), Vec3(1, 0, 0)}), 2u) << scale;
    EXPECT_EQ(query.count({scale * Vec3(1, 1, 1), Vec3(1, 1, 1)}), 1u) << scale;
  }
}

TEST(UnitRayQuery, RaysThatAreNoneAreRefused) {
  const RayQuery query(cube(1));
  EXPECT_THROW(query.all({Vec3(0), Vec3(0)}), InputError);
  EXPECT_THROW(query.all({Vec3(NAN, 0, 0), Vec3(1)}), InputError);
  EXPECT_THROW(query.all({Vec3(0), Vec3(INFINITY, 0, 0)}), InputError);
  EXPECT_THROW(RayQuery(TriangleMesh{}), InputError);
}

}  // namespace
}  // namespace pellucid::groundtruth
