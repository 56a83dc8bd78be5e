// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/rays/packet_predicate.h"

#include <gtest/gtest.h>

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

INSTANTIATE_TEST_SUITE_P(Cameras, PropertyPacketPredicate,
                         ::testing::Combine(::testing::Values(scene::Projection::perspective,
                                                              scene::Projection::orthographic),
                                            ::testing::Values(Precision::rounded,
                                                              Precision::exact)));

}  // namespace
}  // namespace pellucid::groundtruth
