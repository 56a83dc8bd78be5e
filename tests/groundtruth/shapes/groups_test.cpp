// SPDX-License-Identifier: GPL-3.0-or-later
// What shares a box of the hierarchy.
#include <gtest/gtest.h>

#include <random>

#include "groundtruth/shapes/point_groups.h"
#include "groundtruth/shapes/segment_groups.h"

namespace pellucid::groundtruth {
namespace {

std::vector<Vec3> random_points(std::size_t count) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1, 1);
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < count; ++i)
    points.emplace_back(any(random), 1e3 * any(random), any(random));
  return points;
}

TEST(PropertyPointGroups, EveryPointIsInOneGroup) {
  for (const std::size_t count : {0u, 1u, 7u, 8u, 9u, 1000u, 70000u}) {
    const PointGroups groups(random_points(count));
    EXPECT_EQ(groups.points(), count);
    std::vector<int> times(count);
    for (std::uint32_t k = 0; k < groups.count(); ++k) {
      EXPECT_LE(groups.of(k).size(), PointGroups::size);
      EXPECT_GE(groups.of(k).size(), 1u);
      for (const std::uint32_t point : groups.of(k)) ++times[point];
    }
    EXPECT_EQ(times, std::vector<int>(count, 1)) << count;
  }
}

TEST(UnitPointGroups, PointsOfAGroupLieNearEachOther) {
  constexpr std::size_t count = 70000;
  const std::vector<Vec3> points = random_points(count);
  const PointGroups groups(points);
  double volume = 0;  // of all groups' boxes
  for (std::uint32_t k = 0; k < groups.count(); ++k) {
    Box3 box;
    for (const std::uint32_t point : groups.of(k)) box.extend(points[point]);
    const Vec3 size = box.max - box.min;
    volume += size.x * size.y * size.z;
  }
  EXPECT_LT(volume,
            4 * 8e3);  // 8000 of all points together: as they come each group would fill that
}

TEST(UnitPointGroups, EqualAndFlatPointsAreGrouped) {
  EXPECT_EQ(PointGroups(std::vector<Vec3>(20, Vec3(1))).count(), 3u);
  EXPECT_EQ(PointGroups(std::vector<Vec3>{{0, 0, 0}, {1.7e308, 0, 0}, {-1.7e308, 0, 0}}).count(),
            1u);
}

TEST(PropertySegmentGroups, AreShortAndOfOneLine) {
  geometry::LineSet lines;
  lines.positions = random_points(400);
  lines.offsets = {0, 100, 100, 101, 102, 250, 400};
  for (std::size_t i = 250; i < 400; ++i) lines.positions[i] = Vec3(1e-3 * double(i), 0, 0);
  constexpr double longest = 5.5e-3;
  const SegmentGroups groups(lines, longest);
  EXPECT_EQ(groups.segments(), lines.segment_count());
  // Each line's own: 99, 147 and 149 segments, the last ones five a group.
  EXPECT_EQ(groups.count(), 99u + 147u + 30u);
  std::uint32_t next = 0;
  for (std::uint32_t k = 0; k < groups.count(); ++k) {
    EXPECT_EQ(groups.begin(k), next);
    next = groups.end(k);
    EXPECT_LE(next - groups.begin(k), 5u);
  }
  EXPECT_EQ(next, groups.segments());
  EXPECT_EQ(SegmentGroups(lines, 1e9).end(0), 8u);
  EXPECT_EQ(SegmentGroups(geometry::LineSet(), 1).count(), 0u);
}

}  // namespace
}  // namespace pellucid::groundtruth
