// SPDX-License-Identifier: GPL-3.0-or-later
// Points as discs and as spheres: closed forms of their pictures.

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>

#include "groundtruth/traversal/crossing_finder.h"
#include "tests/support/scenes.h"

namespace pellucid::groundtruth {
namespace {

using namespace testing;

scene::PointObject points(const std::vector<Vec3>& positions, double radius,
                          scene::PointObject::Profile profile) {
  scene::PointObject object{{}, radius, profile};
  object.set.positions = positions;
  object.set.colors.assign(positions.size(), Rgba(1, 0.5, 0.25, 0.5));
  return object;
}

TEST(UnitDisc, RimRunsThroughPixelCentresAndIsCrossedOnItsLeftHalf) {
  // One unit is one pixel: the rim passes the centres at (±3, ±4), (±4, ±3), (±5, 0), (0, ±5)
  // exactly, of which those with negative x count.
  scene::Scene scene = orthographic_scene(16, 16);
  scene.camera.height = 16;
  scene.lighting = scene::Lighting::headlight;
  scene.objects = {{"", points({{0.5, -0.5, 1}}, 5, scene::PointObject::Profile::disc)}};
  const CrossingFinder finder(scene, Precision::exact);
  std::vector<Crossing> crossings;
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) {
      const PictureRay ray = finder.frame().ray(x + 0.5, y + 0.5);
      finder.find(ray, crossings);
      const int dx = x - 8, dy = y - 8, squared = dx * dx + dy * dy;
      const bool inside = squared < 25 || (squared == 25 && dx < 0);
      ASSERT_EQ(crossings.size(), inside ? 1u : 0u) << dx << " " << dy;
      if (!inside) continue;
      EXPECT_EQ(crossings[0].depth, 4 * finder.frame().units_per_length());
      const Fragment fragment = finder.shade(crossings[0], finder.frame().world_direction(ray));
      // On this grid of integers all is exact but the root and the quotient.
      EXPECT_NEAR(fragment.color.r, std::sqrt(1 - squared / 25.0), 1e-15);
      EXPECT_EQ(fragment.opacity, 0.5);
    }
}

TEST(AgreementDisc, RoundingDecidesNothing) {
  // Rays within rounding of the rim of a disc that no double describes well, against integers:
  // doubles of [1/2, 2) times 2^60 are integers.
  using Integer = boost::multiprecision::cpp_int;
  const auto integer = [](double x) { return Integer(std::ldexp(x, 60)); };
  const Vec3 center(1.0 / 3, -0.7, 1.9);
  const double radius = 0.1;
  int inside = 0, uncertain = 0;
  for (int i = 0; i < 2000; ++i) {
    const double angle = 0.01 + 2 * std::numbers::pi * i / 2000;
    const PictureRay ray{center.x + radius * std::cos(angle), center.y + radius * std::sin(angle),
                         scene::Projection::orthographic};
    double squared = 0, rounded_squared = 0;
    const bool exact = RayPredicate(ray, 2, Precision::exact).crosses_disc(center, radius, squared);
    const bool rounded =
        RayPredicate(ray, 2, Precision::rounded).crosses_disc(center, radius, rounded_squared);
    const Integer x = integer(center.x) - integer(ray.x), y = integer(center.y) - integer(ray.y);
    ASSERT_EQ(exact, x * x + y * y < integer(radius) * integer(radius)) << angle;
    inside += exact;
    uncertain += exact != rounded;
  }
  EXPECT_GT(inside, 500);
  EXPECT_GT(uncertain, 100) << "rounding alone would have done";
}

TEST(UnitSphere, NestedSpheresAreEnteredAndLeftInTurn) {
  // Radii 1, 1/2, 1/4, seen along z at distance q from the centre: half chords √(r² - q²), and
  // |n · v| = half chord / r.
  scene::Scene scene = orthographic_scene(64, 64);
  scene.camera.height = 2;
  scene.lighting = scene::Lighting::headlight;
  for (const double radius : {0.25, 1.0, 0.5})
    scene.objects.push_back({"", points({{0, 0, 0}}, radius, scene::PointObject::Profile::sphere)});
  const CrossingFinder finder(scene, Precision::exact);
  const double unit = finder.frame().units_per_length();
  std::vector<Crossing> crossings;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      const PictureRay ray = finder.frame().ray(x + 0.5, y + 0.5);
      finder.find(ray, crossings);
      const double q = std::hypot((x + 0.5) / 32 - 1, (y + 0.5) / 32 - 1);
      std::vector<double> radii;
      for (const double radius : {1.0, 0.5, 0.25})
        if (q < radius) radii.push_back(radius);
      ASSERT_EQ(crossings.size(), 2 * radii.size());
      for (std::size_t i = 0; i < radii.size(); ++i) {
        const double half = std::sqrt(radii[i] * radii[i] - q * q);
        const Crossing &in = crossings[i], &out = crossings[crossings.size() - 1 - i];
        // Half is the root of a difference of squares that round by 1.1e-16 · 5, and d√x = dx /
        // 2√x; its share of the radius is off by the same, and no pixel is nearer a rim than a
        // tenth.
        EXPECT_NEAR(in.depth, (5 - half) * unit, 1e-15 * 5 / half);
        EXPECT_NEAR(out.depth, (5 + half) * unit, 1e-15 * 5 / half);
        const Fragment fragment = finder.shade(in, finder.frame().world_direction(ray));
        EXPECT_NEAR(fragment.color.r, half / radii[i], 1e-14);
      }
    }
}

TEST(UnitSphere, ATinyFarSphereIsPrecise) {
  // Radius 1e-4 at distance 300: its depth to 1e-9 of the radius; float has it wrong by 0.16.
  scene::Scene scene;
  scene.width = scene.height = 101;
  scene.camera = {.eye = {0, 0, 300}, .target = {0, 0, 0}, .fov = 4e-5};
  const double radius = 1e-4;
  scene.objects = {{"", points({{0, 0, 0}}, radius, scene::PointObject::Profile::sphere)},
                   {"", full_layer(-1, Rgba(1))}};
  const CrossingFinder finder(scene, Precision::exact);
  const double unit = finder.frame().units_per_length();
  std::vector<Crossing> crossings;
  for (int y = 0; y < 101; ++y)
    for (int x = 0; x < 101; ++x) {
      const PictureRay ray = finder.frame().ray(x + 0.5, y + 0.5);
      finder.find(ray, crossings);
      const double cosine = 1 / std::sqrt(1 + ray.x * ray.x + ray.y * ray.y);
      const double q = 300 * std::hypot(ray.x, ray.y) * cosine;
      if (std::abs(q - radius) < 1e-9 * radius) continue;
      ASSERT_EQ(crossings.size(), q < radius ? 3u : 1u);
      if (q > 0.99 * radius) continue;
      const double near = (300 * cosine - std::sqrt(radius * radius - q * q)) * cosine;
      // The depth of 300 itself, an ulp of 5.7e-14, is 5.7e-10 of the radius; the formula here
      // takes some ten roundings of it.
      EXPECT_NEAR(crossings[0].depth / unit, near, 1e-8 * radius);
    }
}

TEST(UnitSphere, AnEyeWithinSeesTheFarSide) {
  scene::Scene scene;
  scene.width = scene.height = 8;
  scene.camera = {.eye = {0.25, 0, 0}, .target = {0, 0, 0}};
  scene.objects = {{"", points({{0, 0, 0}}, 1, scene::PointObject::Profile::sphere)}};
  const CrossingFinder finder(scene, Precision::exact);
  std::vector<Crossing> crossings;
  for (int i = 0; i < 8; ++i) {
    finder.find(finder.frame().ray(i + 0.5, 4), crossings);
    ASSERT_EQ(crossings.size(), 1u);
    EXPECT_GT(crossings[0].v, 0);
  }
}

}  // namespace
}  // namespace pellucid::groundtruth
