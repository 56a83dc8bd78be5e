// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles cut off at the guard band are parts of themselves, and fit together as before.
#include "oit/shapes/guard_band.h"

#include <gtest/gtest.h>

#include <random>

#include "scene/view_depth.h"
#include "tests/support/scenes.h"

namespace pellucid::oit {
namespace {

using namespace pellucid::testing;

ViewSpace view_of(scene::Scene scene) {
  scene.objects = {sheet(1, Rgba(1)), sheet(-1, Rgba(1))};
  return {scene, scene::depth_range(scene)};
}

std::vector<ViewSpace> views() {
  scene::Scene perspective = empty_scene(40, 30);
  perspective.camera = {};
  return {view_of(empty_scene(40, 30)), view_of(perspective)};
}

/// Corners at distances of all sizes, on all sides of the eye.
class RandomCorners {
 public:
  explicit RandomCorners(unsigned seed) : random_(seed) {}
  Vec3 next() {
    std::uniform_real_distribution<double> unit(-1, 1);
    const double size = std::pow(10, 4 + 4 * unit(random_));
    return {size * unit(random_), size * unit(random_), size * unit(random_)};
  }

 private:
  std::mt19937 random_;
};

TEST(PropertyGuardBand, PartsLieInTheTriangleAndInTheBand) {
  for (const ViewSpace& view : views()) {
    const GuardBand band(view);
    RandomCorners corners(1);
    int parts = 0;
    for (int n = 0; n < 5000; ++n) {
      const std::array<Vec3, 3> triangle{corners.next(), corners.next(), corners.next()};
      std::vector<ClippedCorner> part;
      band.clip(triangle, part);
      parts += !part.empty();
      for (const ClippedCorner& corner : part) {
        Vec3 expected(0);
        double size = 1;
        for (int i = 0; i < 3; ++i) {
          EXPECT_GE(corner.weights[i], -1e-12);
          expected += corner.weights[i] * triangle[std::size_t(i)];
          size = std::max(size, glm::length(triangle[std::size_t(i)]));
        }
        EXPECT_NEAR(corner.weights.x + corner.weights.y + corner.weights.z, 1, 1e-12);
        // A few roundings of the corners.
        EXPECT_LE(glm::length(corner.position - expected), 1e-13 * size);
        // 16 halves of the picture, of depths up to 16 ranges.
        const double w = view.w(corner.position.z);
        EXPECT_LE(std::abs(view.clip_scale().x * corner.position.x), 16 * w + 1e-9);
        EXPECT_LE(std::abs(view.clip_scale().y * corner.position.y), 16 * w + 1e-9);
        EXPECT_GE(corner.position.z, view.nearest_drawn() - 1e-9);
        EXPECT_LE(corner.position.z, 16.5 + 1e-9);
      }
    }
    EXPECT_GT(parts, 20);
  }
}

TEST(PropertyGuardBand, TrianglesThatShareAnEdgeShareItsCutEnds) {
  for (const ViewSpace& view : views()) {
    const GuardBand band(view);
    RandomCorners corners(2);
    int cuts = 0;
    for (int n = 0; n < 20000; ++n) {
      const Vec3 a = corners.next(), b = corners.next(), c = corners.next(), d = corners.next();
      std::vector<ClippedCorner> left, right;
      band.clip({a, b, c}, left);
      band.clip({b, a, d}, right);
      if (left.empty() || right.empty()) continue;
      for (const ClippedCorner& p : left) {
        if (p.weights.z != 0 || p.weights.x == 1 || p.weights.y == 1) continue;
        ++cuts;
        EXPECT_TRUE(std::ranges::any_of(
            right, [&](const ClippedCorner& q) { return p.position == q.position; }));
      }
    }
    EXPECT_GT(cuts, 20);
  }
}

// Edges through the middle of the picture stay there however far their ends are.
TEST(UnitGuardBand, CutsOfFarCornersAreRight) {
  for (const ViewSpace& view : views())
    for (const double size : {1e3, 1e10, 1e38, 1e76, 1e99}) {
      std::vector<ClippedCorner> part;
      GuardBand(view).clip({Vec3(-size, -size, 0.5), Vec3(size, -size, 0.5), Vec3(size, size, 0.5)},
                           part);
      bool corner_on_diagonal = false;
      for (const ClippedCorner& corner : part) {
        EXPECT_NEAR(corner.position.z, 0.5, 1e-14);  // a rounding at every step
        EXPECT_GE(corner.position.x, corner.position.y);
        corner_on_diagonal |= corner.position.x == corner.position.y && corner.position.x > 0.1;
      }
      EXPECT_TRUE(corner_on_diagonal) << size;
    }
}

TEST(UnitGuardBand, WhatMissesThePictureIsLeftOut) {
  for (const ViewSpace& view : views()) {
    const GuardBand band(view);
    std::vector<ClippedCorner> part(3);
    band.clip({Vec3(1e9, 0, 0.5), Vec3(2e9, 0, 0.5), Vec3(1e9, 1, 0.5)}, part);
    EXPECT_TRUE(part.empty());
    EXPECT_TRUE(band.disc_misses_picture({100, 0, 0.5}, 50));
    EXPECT_FALSE(band.disc_misses_picture({100, 0, 0.5}, 100));
    EXPECT_FALSE(band.holds_disc({0, 0, 0.5}, 1e6));
    EXPECT_TRUE(band.holds_disc({0, 0, 0.5}, 1e3));
  }
}

}  // namespace
}  // namespace pellucid::oit
