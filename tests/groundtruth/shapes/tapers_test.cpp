// SPDX-License-Identifier: GPL-3.0-or-later
// Radii that differ from point to point: discs, spheres, ribbons that narrow, and tubes.

#include <gtest/gtest.h>

#include <random>

#include "tests/groundtruth/shapes/tapers.h"

namespace pellucid::groundtruth {
namespace {

using namespace testing;
using LineProfile = scene::LineObject::Profile;
using PointProfile = scene::PointObject::Profile;

class UnitTaperedPoints : public ::testing::TestWithParam<PointProfile> {};

// Centres of pixels are 1/32 apart: those within each radius, and none of the point of radius 0.
TEST_P(UnitTaperedPoints, EachHasItsRadius) {
  scene::Scene scene = orthographic_scene(64, 64);
  const std::vector<Vec3> centers{{-0.5, 0.5, 0}, {0.5, 0.5, 0}, {-0.5, -0.5, 0}, {0.5, -0.5, 0}};
  const std::vector<double> radii{0.4, 0.2, 0, 0.1};
  scene::PointObject points;
  points.radius = scene::Radii(radii);
  points.profile = GetParam();
  points.set.positions = centers;
  points.set.colors.assign(4, Rgba(0.5));
  scene.objects = {{"points", points}};
  see_all(scene, [&](int x, int y, const std::vector<Crossing>& crossings) {
    const Vec2 p((x + 0.5) / 32 - 1, 1 - (y + 0.5) / 32);
    const std::size_t k = std::size_t((p.x > 0) + 2 * (p.y < 0));
    const double q = glm::length(p - Vec2(centers[k])), r = radii[k];
    const bool sphere = GetParam() == PointProfile::sphere;
    ASSERT_EQ(crossings.size(), q < r ? (sphere ? 2u : 1u) : 0u) << x << ' ' << y;
    for (const Crossing& c : crossings) {
      const double half = std::sqrt(r * r - q * q);
      // As of a straight tube: half is the root of a difference of squares.
      EXPECT_NEAR(std::abs(c.depth - 5), sphere ? half : 0, 1e-15 * 5 / half);
      EXPECT_NEAR(std::abs(c.v), half / r, 1e-13);
    }
  });
}

INSTANTIATE_TEST_SUITE_P(Of, UnitTaperedPoints,
                         ::testing::Values(PointProfile::disc, PointProfile::sphere),
                         [](const auto& of) {
                           return of.param == PointProfile::disc ? "Discs" : "Spheres";
                         });

// From a half width of 0.5 at x = -1 to a tip at 1: a triangle.
TEST(UnitTaperedRibbon, IsAsWideAsItsRadiusEverywhere) {
  scene::Scene scene = orthographic_scene(64, 64);
  scene.objects = {
      tapered_line({{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}}, {0.5, 0.25, 0}, LineProfile::ribbon)};
  see_all(scene, [&](int x, int y, const std::vector<Crossing>& crossings) {
    const double px = (x + 0.5) / 32 - 1, py = 1 - (y + 0.5) / 32;
    ASSERT_EQ(crossings.size(), std::abs(py) < 0.25 * (1 - px) ? 1u : 0u) << x << ' ' << y;
  });
}

/// A walk that meets itself, of radii from 0 on.
struct Walk {
  std::vector<Vec3> points;
  std::vector<double> radii;
};
Walk walk() {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  Walk walk;
  for (int i = 0; i < 30; ++i) {
    walk.points.emplace_back(unit(random), unit(random), unit(random));
    walk.radii.push_back(i % 7 == 0 ? 0 : 0.15 * (1 + unit(random)));
  }
  return walk;
}

scene::Scene walk_scene(const Walk& walk) {
  scene::Scene scene;
  scene.width = scene.height = 40;
  scene.camera = {.eye = {0.2, 0.3, 4}, .fov = 40};
  scene.objects = {tapered_line(walk.points, walk.radii)};
  return scene;
}

TEST(AgreementTaperedTube, EntersAndLeavesTheSolidByTurns) {
  const Walk line = walk();
  const scene::Scene scene = walk_scene(line);
  const auto inside = [&](const Vec3& x) {
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i)
      if (depth_within(line.points[i], line.points[i + 1], line.radii[i], line.radii[i + 1], x) > 0)
        return true;
    return false;
  };
  const CrossingFinder finder(scene, Precision::exact);
  std::vector<Crossing> crossings;
  std::size_t deepest = 0;
  for (int y = 0; y < 40; y += 6)
    for (int x = 0; x < 40; ++x) {
      const PictureRay ray = finder.frame().ray(x + 0.5, y + 0.5);
      finder.find(ray, crossings);
      ASSERT_EQ(crossings.size() % 2, 0u);
      deepest = std::max(deepest, crossings.size());
      const Vec3 direction = finder.frame().world_direction(ray);
      std::size_t passed = 0;
      for (double depth = 2; depth < 6; depth += 0.08) {
        const double units = depth * finder.frame().units_per_length();
        while (passed < crossings.size() && crossings[passed].depth < units) ++passed;
        ASSERT_EQ(inside(scene.camera.eye + depth * direction), passed % 2 == 1)
            << x << ' ' << y << ' ' << depth;
      }
    }
  EXPECT_GE(deepest, 6u);
}

TEST(PropertyTaperedTube, EitherOrderOfItsPointsIsTheSameSolid) {
  Walk line = walk();
  std::vector<double> depths[2];
  for (auto& list : depths) {
    see_all(walk_scene(line), [&](int, int, const std::vector<Crossing>& crossings) {
      for (const Crossing& c : crossings) list.push_back(c.depth);
    });
    std::ranges::reverse(line.points);
    std::ranges::reverse(line.radii);
  }
  EXPECT_GT(depths[0].size(), 1000u);
  EXPECT_EQ(depths[0], depths[1]);
}

// One object of two lines, of which the second alone narrows: the first has the bits that it has
// with one radius.
TEST(PropertyTaperedTube, WhereRadiiAreEqualNothingChanges) {
  for (const LineProfile profile : {LineProfile::tube, LineProfile::ribbon}) {
    std::vector<Crossing> lists[2];
    for (const double last : {0.1, 0.05}) {
      scene::Scene scene = walk_scene(walk());
      auto& lines = std::get<scene::LineObject>(scene.objects[0].shape);
      std::vector<double> radii(lines.set.positions.size(), 0.1);
      lines.set.positions.insert(lines.set.positions.end(), {{5, 5, 0}, {5, 6, 0}});
      lines.set.colors.insert(lines.set.colors.end(), 2, Rgba(0.5));
      lines.set.offsets.push_back(lines.set.positions.size());
      radii.insert(radii.end(), {0.1, last});
      lines.radius = scene::Radii(radii);
      lines.profile = profile;
      EXPECT_EQ(lines.radius.vary(), last != 0.1);
      auto& list = lists[last != 0.1];
      see_all(scene, [&](int, int, const std::vector<Crossing>& crossings) {
        list.insert(list.end(), crossings.begin(), crossings.end());
      });
    }
    ASSERT_GT(lists[0].size(), 100u);
    ASSERT_EQ(lists[0].size(), lists[1].size());
    for (std::size_t i = 0; i < lists[0].size(); ++i) {
      EXPECT_EQ(lists[0][i].depth, lists[1][i].depth);
      EXPECT_EQ(lists[0][i].u, lists[1][i].u);
      EXPECT_EQ(lists[0][i].v, lists[1][i].v);
    }
  }
}

}  // namespace
}  // namespace pellucid::groundtruth
