// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/rays/packet_predicate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "groundtruth/rays/triangle_point.h"

namespace pellucid::groundtruth {
namespace {

class PropertyPacketPredicate
    : public ::testing::TestWithParam<std::tuple<scene::Projection, Precision>> {};

/// Coordinates of few values, so that rays meet edges and vertices and triangles degenerate, or of
/// any.
double coordinate(std::mt19937& random, bool few) {
  if (few) return (int(random() % 5) - 2) / 2.0;
  return std::uniform_real_distribution<double>(-1, 1)(random);
}

TEST_P(PropertyPacketPredicate, SaysWhatTheTestOfEachRaySays) {
  const auto [projection, precision] = GetParam();
  std::mt19937 random(11);
  int crossed = 0, on_edges = 0;
  for (int round = 0; round < 4000; ++round) {
    const bool few = round % 2;
    const auto vertex = [&] {
      return Vec3(coordinate(random, few), coordinate(random, few), 1 + random() % 2);
    };
    const Vec3 a = vertex(), b = vertex(), c = vertex();
    std::vector<RayPredicate> tests;
    for (std::size_t i = 0; i < PacketPredicate::width; ++i)
      tests.emplace_back(PictureRay{coordinate(random, few), coordinate(random, few), projection},
                         2, precision);
    PacketPredicate packet;
    for (std::size_t i = 0; i < tests.size(); ++i) packet.set(i, tests[i]);
    const std::uint32_t lanes = random() % (1u << PacketPredicate::width);
    PacketPredicate::Points together;
    const std::uint32_t found = packet.crosses(a, b, c, lanes, together);
    EXPECT_EQ(found & ~lanes, 0u);
    for (std::size_t i = 0; i < tests.size(); ++i) {
      EdgeFunctions alone;
      const bool crosses = tests[i].crosses(a, b, c, alone) && (lanes >> i & 1);
      ASSERT_EQ(found >> i & 1, crosses);
      if (!crosses) continue;
      ++crossed;
      for (int k = 0; k < 3; ++k) on_edges += alone.e[k] == 0;
      tests[i].sharpen(a, b, c, alone);
      const TrianglePoint point = triangle_point(alone, a, b, c);
      EXPECT_EQ(together.depth[i], point.depth);
      EXPECT_EQ(together.u[i], point.u);
      EXPECT_EQ(together.v[i], point.v);
    }
  }
  EXPECT_GT(crossed, 500);
  EXPECT_GT(on_edges, 50);
}

/// The squared distance of a ray's line from a point.
double squared_distance(const PictureRay& ray, const Vec3& x) {
  const bool perspective = ray.projection == scene::Projection::perspective;
  const Vec3 from = perspective ? x : x - Vec3(ray.x, ray.y, 0);
  const Vec3 across = glm::cross(from, perspective ? Vec3(ray.x, ray.y, 1) : Vec3(0, 0, 1));
  const double length = perspective ? 1 + ray.x * ray.x + ray.y * ray.y : 1;
  return glm::dot(across, across) / length;
}

TEST_P(PropertyPacketPredicate, PassesByNoRayThatMeetsABallOrADisc) {
  const auto [projection, precision] = GetParam();
  std::mt19937 random(12);
  std::uniform_real_distribution<double> any(-1, 1);
  int met = 0, in_vain = 0, passed = 0;
  for (int round = 0; round < 4000; ++round) {
    const double scale = std::pow(10, 4 * any(random)), field = std::pow(10, -2 + 2 * any(random));
    const Vec3 center = scale * Vec3(field * any(random), field * any(random), any(random));
    const double radius = scale * field * std::abs(any(random));
    std::vector<RayPredicate> tests;
    for (std::size_t i = 0; i < PacketPredicate::width; ++i) {
      const double size = projection == scene::Projection::perspective ? field : scale * field;
      tests.emplace_back(PictureRay{size * any(random), size * any(random), projection}, 2 * scale,
                         precision);
    }
    PacketPredicate packet;
    for (std::size_t i = 0; i < tests.size(); ++i) packet.set(i, tests[i]);
    const std::uint32_t lanes = random() % (1u << PacketPredicate::width);
    const std::uint32_t near = packet.may_meet(center, radius, lanes);
    EXPECT_EQ(near & ~lanes, 0u);
    for (std::size_t i = 0; i < tests.size(); ++i) {
      if ((lanes >> i & 1) == 0) continue;
      double unused = 0;
      const bool meets = squared_distance(tests[i].ray(), center) < radius * radius;
      const bool crosses = center.z > 0 && tests[i].crosses_disc(center, radius, unused);
      ASSERT_TRUE(!(meets || crosses) || (near >> i & 1)) << round;
      met += meets;
      passed += (near >> i & 1) == 0;
      in_vain += !meets && (near >> i & 1);
    }
  }
  EXPECT_GT(met, 2000);
  EXPECT_GT(passed, 2000);
  EXPECT_LT(in_vain, met / 4);  // rays of up to 45 degrees to the view among them
}

INSTANTIATE_TEST_SUITE_P(Cameras, PropertyPacketPredicate,
                         ::testing::Combine(::testing::Values(scene::Projection::perspective,
                                                              scene::Projection::orthographic),
                                            ::testing::Values(Precision::rounded,
                                                              Precision::exact)));

}  // namespace
}  // namespace pellucid::groundtruth
