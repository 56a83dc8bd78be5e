// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/view/ribbon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scene/scene.h"
#include "scene/view_depth.h"

namespace pellucid::scene {
namespace {

constexpr double radius = 0.25;

std::vector<Vec3> half_widths(const std::vector<Vec3>& points, const Camera& camera) {
  std::vector<Vec3> widths;
  ribbon_half_widths(points, radius, camera_frame(camera), camera.projection, widths);
  return widths;
}

TEST(UnitRibbon, FacesTheEyeAndHasItsWidth) {
  const Camera camera{.eye = {0.3, -0.2, 4}};
  std::vector<Vec3> helix;
  for (int i = 0; i < 200; ++i) helix.emplace_back(std::cos(0.1 * i), std::sin(0.1 * i), 0.01 * i);
  const auto w = half_widths(helix, camera);
  ASSERT_EQ(w.size(), helix.size());
  for (std::size_t i = 1; i + 1 < helix.size(); ++i) {
    // Unit vectors to some 3e-16, times distances up to 5 and the radius; the dot products add
    // three.
    EXPECT_NEAR(glm::length(w[i]), radius, 1e-14);
    EXPECT_NEAR(glm::dot(w[i], helix[i] - camera.eye), 0, 1e-14);
    EXPECT_NEAR(glm::dot(w[i], helix[i + 1] - helix[i - 1]), 0, 1e-14);
  }
}

TEST(UnitRibbon, OrthographicLineAlongXIsWideAlongY) {
  const Camera camera{.projection = Projection::orthographic};
  for (const Vec3& w : half_widths({{0, 0, 0}, {1, 0, 0}, {2, 0, 1}}, camera)) {
    // One normalization and a product.
    EXPECT_NEAR(std::abs(w.y), radius, 1e-15);
    EXPECT_EQ(w.z, 0);
  }
}

TEST(UnitRibbon, DoesNotCrossItselfWhereTheLineTurnsAwayFromTheEye) {
  // The picture of this line runs right and back left: t × v changes its side on the way.
  const Camera camera{.projection = Projection::orthographic};
  const auto w = half_widths({{0, 0, 0}, {1, 0, 1}, {1, 0, 2}, {0, 0, 3}}, camera);
  for (std::size_t i = 1; i < w.size(); ++i) EXPECT_GT(glm::dot(w[i], w[i - 1]), 0) << i;
}

TEST(UnitRibbon, APointThatIsThereTwiceChangesNothing) {
  const Camera camera{.eye = {0.3, -0.2, 4}};
  const std::vector<Vec3> plain{{-1, 0, 0}, {0, 0, 0.5}, {0, 1, 0}, {0.5, 1, 0}, {0, 1, 0}};
  const auto expected = half_widths(plain, camera);
  for (const std::size_t times : {2, 3})
    for (std::size_t again = 0; again < plain.size(); ++again) {
      std::vector<Vec3> points = plain;
      points.insert(points.begin() + std::ptrdiff_t(again), times - 1, plain[again]);
      const auto w = half_widths(points, camera);
      ASSERT_EQ(w.size(), points.size());
      for (std::size_t i = 0; i < w.size(); ++i)
        EXPECT_EQ(w[i], expected[i < again + times ? std::min(i, again) : i - (times - 1)])
            << "point " << again << ", " << times << " times: " << i;
    }
}

TEST(UnitRibbon, DirectionsOfAllPointsAreThoseOfEach) {
  for (const std::vector<Vec3>& points :
       {std::vector<Vec3>{},
        {{1, 2, 3}},
        {{1, 2, 3}, {1, 2, 3}},
        {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 2, 0}, {1, 0, 0}, {1, 0, 0}}}) {
    std::vector<Vec3> all{Vec3(7)};
    line_directions(points, all);
    ASSERT_EQ(all.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(all[i], line_direction(points, i));
  }
  // Straight back at (1, 2, 0): the way onwards.
  const std::vector<Vec3> back{{1, 0, 0}, {1, 2, 0}, {1, 2, 0}, {1, 0, 0}};
  EXPECT_EQ(line_direction(back, 1), Vec3(0, -2, 0));
}

TEST(UnitRibbon, StandsStillAndRunsAlongTheViewWithoutLosingItsWidth) {
  const Camera camera{.eye = {0, 0, 5}};
  for (const auto& line :
       {std::vector<Vec3>{{0, 0, 0}, {0, 0, 1}, {0, 0, 2}},
        std::vector<Vec3>{{1, 1, 0}, {1, 1, 0}, {1, 1, 0}}, std::vector<Vec3>{{1, 1, 0}}})
    // A normalization and a product: some 4 · 1.1e-16 of the radius.
    for (const Vec3& w : half_widths(line, camera)) EXPECT_NEAR(glm::length(w), radius, 1e-14);
  EXPECT_TRUE(half_widths({}, camera).empty());
}

TEST(UnitDepthRange, HoldsTheWidthsOfLinesAndPoints) {
  Scene scene;
  scene.camera.projection = Projection::orthographic;  // looks along -z from z = 5
  PointObject points{{}, radius, PointObject::Profile::sphere};
  points.set.positions = {{0, 0, 0}};
  scene.objects.push_back({"points", points});
  const auto near = [&] { return depth_range(scene).near; };
  // The margin: a 1e-5th of the depth range, at most 2 long.
  EXPECT_NEAR(near(), 5 - radius, 2.1e-5);
  std::get<PointObject>(scene.objects[0].shape).profile = PointObject::Profile::disc;
  scene.objects.push_back({"tube", LineObject{{}, 1, LineObject::Profile::tube}});
  auto& line = std::get<LineObject>(scene.objects[1].shape);
  line.set.positions = {{0, 0, 0}, {1, 0, 0}};
  line.set.offsets = {0, 2};
  // The same margin.
  EXPECT_NEAR(near(), 4, 2.1e-5);
  line.profile = LineObject::Profile::ribbon;  // all of it at z = 0, as the disc
  EXPECT_GT(near(), 2);
  EXPECT_NEAR(depth_range(scene).normalized(5), 0.5, 1e-12);
  EXPECT_EQ(scene.bounds().max, Vec3(2, 1, 1));
}

}  // namespace
}  // namespace pellucid::scene
