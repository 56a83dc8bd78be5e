// SPDX-License-Identifier: GPL-3.0-or-later
// Shares of elements, and objects that are cut down to them.

#include "scene/parts/scene_part.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/scenes.h"

namespace pellucid::scene {
namespace {

TEST(PropertyShare, SharesAreAllElementsEachOnce) {
  for (const std::uint64_t count : {0ull, 1ull, 2ull, 7ull, 100ull, 4294967295ull, 1ull << 60})
    for (const int parts : {1, 2, 3, 7, most_parts})
      for (const std::size_t object : {0u, 1u, 5u}) {
        std::uint64_t sum = 0, least = std::numeric_limits<std::uint64_t>::max(), most = 0;
        for (int part = 1; part <= parts; ++part) {
          const Share share = share_of_cells(count, object, {part, parts});
          ASSERT_LE(share.begin, share.end);
          sum += share.end - share.begin;
          least = std::min(least, share.end - share.begin);
          most = std::max(most, share.end - share.begin);
          // The next part begins where this one ends; the last one is followed by the first.
          const Share next = share_of_cells(count, object, {part % parts + 1, parts});
          ASSERT_EQ(share.end == count ? 0 : share.end, next.begin % std::max(count, 1ul));
        }
        EXPECT_EQ(sum, count);
        EXPECT_LE(most - least, 1u);
      }
}

TEST(UnitShare, ObjectsOfOneElementAreSpreadOverTheParts) {
  for (int part = 1; part <= 4; ++part) {
    std::uint64_t held = 0;
    for (std::size_t object = 0; object < 8; ++object) {
      const Share share = share_of_cells(1, object, {part, 4});
      held += share.end - share.begin;
    }
    EXPECT_EQ(held, 2u);
  }
}

TEST(PropertyShare, ObjectsInARowAreSharedOutPieceByPiece) {
  const std::vector<std::uint64_t> counts{5, 0, 1, 1ull << 54, 7, 3};
  for (const int parts : {1, 2, 3, 50, most_parts}) {
    std::vector<std::uint64_t> next(counts.size(), 0);
    std::uint64_t least = std::numeric_limits<std::uint64_t>::max(), most = 0;
    for (int part = 1; part <= parts; ++part) {
      std::uint64_t held = 0;
      for (std::size_t object = 0; object < counts.size(); ++object) {
        const Share share = share_of(counts, object, {part, parts});
        ASSERT_LE(share.begin, share.end);
        if (share.begin == share.end) continue;
        ASSERT_EQ(share.begin, next[object]) << "elements follow each other, part by part";
        next[object] = share.end;
        held += share.end - share.begin;
      }
      least = std::min(least, held);
      most = std::max(most, held);
    }
    EXPECT_EQ(next, counts);
    EXPECT_LE(most - least, 1u);
  }
}

TEST(UnitShare, OfAsManyEqualObjectsAsPartsEachHasOne) {
  const std::vector<std::uint64_t> counts(8, 1000);
  for (std::size_t object = 0; object < 8; ++object)
    for (int part = 1; part <= 8; ++part) {
      const Share share = share_of(counts, object, {part, 8});
      EXPECT_EQ(share.end - share.begin, std::size_t(part) == object + 1 ? 1000u : 0u);
    }
}

TEST(UnitScenePart, AMeshKeepsItsTrianglesAndTheVerticesThatTheyNeed) {
  const geometry::TriangleMesh whole = testing::sphere(2, Rgba(0.5));
  std::size_t triangles = 0;
  for (int part = 1; part <= 3; ++part) {
    SceneObject object{"", whole};
    object.vertices().scalars["s"].assign(whole.positions.size(), 1);
    const std::uint32_t first =
        cut_object(object, share_of_cells(whole.triangles.size(), 0, {part, 3}));
    const geometry::TriangleMesh& mesh = object.mesh();
    EXPECT_EQ(first, triangles);
    EXPECT_LT(mesh.positions.size(), whole.positions.size());
    EXPECT_EQ(mesh.colors.size(), mesh.positions.size());
    EXPECT_EQ(mesh.normals.size(), mesh.positions.size());
    EXPECT_TRUE(mesh.scalars.empty());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      for (int corner = 0; corner < 3; ++corner)
        EXPECT_EQ(mesh.positions[mesh.triangles[t][corner]],
                  whole.positions[whole.triangles[first + t][corner]]);
    triangles += mesh.triangles.size();
  }
  EXPECT_EQ(triangles, whole.triangles.size());
}

/// Lines of 1, 2, 3, … points: the first one has no segment.
LineObject staircase(int lines, LineObject::Profile profile) {
  LineObject object;
  object.profile = profile;
  for (int k = 1; k <= lines; ++k) {
    for (int i = 0; i < k; ++i) object.set.positions.emplace_back(i, k, 0);
    object.set.offsets.push_back(object.set.positions.size());
  }
  return object;
}

TEST(UnitScenePart, LinesStayWholeAndKeepTheirPlaceInTheCount) {
  for (const auto profile : {LineObject::Profile::ribbon, LineObject::Profile::tube}) {
    SceneObject object{"", staircase(6, profile)};
    const std::uint32_t first = cut_object(object, share_of_cells(6, 0, {2, 3}));
    const auto& set = std::get<LineObject>(object.shape).set;
    // Before the third line lie 0 + 1 segments.
    EXPECT_EQ(first, profile == LineObject::Profile::ribbon ? 2u : 1u);
    EXPECT_EQ(set.offsets, (std::vector<std::uint64_t>{0, 3, 7}));
    EXPECT_EQ(set.positions.size(), 7u);
    EXPECT_EQ(set.positions.front(), Vec3(0, 3, 0));
    EXPECT_EQ(set.positions.back(), Vec3(3, 4, 0));
  }
}

TEST(UnitScenePart, AnObjectMayBeEmpty) {
  SceneObject object{"", testing::random_triangles(1, 1)};
  EXPECT_EQ(cut_object(object, {0, 0}), 0u);
  EXPECT_TRUE(object.mesh().triangles.empty());
  EXPECT_TRUE(object.vertices().positions.empty());
}

}  // namespace
}  // namespace pellucid::scene
