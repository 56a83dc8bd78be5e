// SPDX-License-Identifier: GPL-3.0-or-later
// Hulls of two balls: closed forms, their volume, and a search for the ball that a place is deepest
// in.

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "tests/groundtruth/shapes/tapers.h"

namespace pellucid::groundtruth {
namespace {

using namespace testing;

/// Of one pixel, in the middle, seen along -z from z = 5.
std::vector<Crossing> seen_in_the_middle(const scene::SceneObject& object) {
  scene::Scene scene = orthographic_scene(1, 1);
  scene.objects = {object};
  std::vector<Crossing> found;
  see_all(scene, [&](int, int, const std::vector<Crossing>& c) { found = c; });
  return found;
}

TEST(UnitConeSphere, AlongTheAxisItReachesFromBallToBall) {
  for (const double back : {0.0, 0.1, 0.25, 0.4}) {
    const auto found = seen_in_the_middle(tapered_line({{0, 0, 1}, {0, 0, -1}}, {0.25, back}));
    ASSERT_EQ(found.size(), 2u) << back;
    // Roundings of depths up to 6.25, some ten in a row.
    EXPECT_NEAR(found[0].depth, 4 - 0.25, 1e-14);
    EXPECT_NEAR(found[1].depth, 6 + back, 1e-14);
    EXPECT_NEAR(found[0].u, 0, 1e-14);
    EXPECT_NEAR(found[1].u, 1, 1e-14);
  }
}

// Across the axis at its middle, with sin β = Δ / L = 1/4: ρ = R / cos β, and the balls that touch
// there lie sin β R / cos² β towards the larger one.
TEST(UnitConeSphere, AcrossTheAxisItIsTheMantle) {
  const auto found = seen_in_the_middle(tapered_line({{-1, 0, 0}, {1, 0, 0}}, {0.5, 0}));
  ASSERT_EQ(found.size(), 2u);
  const double sine = 0.25, cosine = std::sqrt(1 - sine * sine), middle = 0.25;
  const double half = middle / cosine, along = -sine * middle / (cosine * cosine);
  EXPECT_NEAR(found[0].depth, 5 - half, 1e-14);
  EXPECT_NEAR(found[1].depth, 5 + half, 1e-14);
  for (const Crossing& c : found) {
    EXPECT_NEAR(c.u, 0.5 + 0.5 * along, 1e-14);
    EXPECT_NEAR(std::abs(c.v), cosine, 1e-14);
  }
}

TEST(UnitConeSphere, ABallThatHoldsTheOtherIsAllThereIs) {
  const scene::SceneObject nested = tapered_line({{0, 0, 0}, {0.1, 0.1, 0.1}}, {0.8, 0.3});
  scene::PointObject ball{{}, 0.8, scene::PointObject::Profile::sphere};
  ball.set.positions = {Vec3(0)};
  ball.set.colors = {Rgba(0.5)};
  std::vector<double> depths[2];
  int i = 0;
  for (const scene::SceneObject& object : {nested, scene::SceneObject{"ball", ball}}) {
    scene::Scene scene = orthographic_scene(32, 32);
    scene.objects = {object};
    see_all(scene, [&](int, int, const std::vector<Crossing>& crossings) {
      for (const Crossing& c : crossings) depths[i].push_back(c.depth);
    });
    ++i;
  }
  EXPECT_GT(depths[0].size(), 500u);
  EXPECT_EQ(depths[0], depths[1]);
}

/// A frustum's volume, with circles of these radii, and a cap's of a ball.
double frustum(double p, double q, double height) {
  return std::numbers::pi / 3 * height * (p * p + p * q + q * q);
}
double cap(double radius, double height) {
  return std::numbers::pi / 3 * height * height * (3 * radius - height);
}

// The chords of all rays add up to the volume.
TEST(PropertyConeSphere, HasItsVolumeFromAllSides) {
  const double a = 0.5, b = 0.1, length = 1, sine = (a - b) / length;
  const double cosine = std::sqrt(1 - sine * sine);
  const double volume = frustum(a * cosine, b * cosine, length - (a - b) * sine) +
                        cap(a, a * (1 + sine)) + cap(b, b * (1 - sine));
  for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(2, -1, 3)}) {
    scene::Scene scene = orthographic_scene(400, 400);
    const Vec3 half = 0.5 * length * glm::normalize(axis);
    scene.objects = {tapered_line({-half, half}, {a, b})};
    double sum = 0;
    see_all(scene, [&](int, int, const std::vector<Crossing>& crossings) {
      for (const Crossing& c : crossings) sum += std::copysign(c.depth, c.v);
    });
    // Chords vanish at the rim as roots do: a sum over pixels of a side h errs by some h².
    EXPECT_NEAR(sum / (200 * 200), volume, 1e-3 * volume);
  }
}

struct Hull {
  Vec3 a, b;
  double ra, rb;
};

/// Of all kinds: slender and flat, tips, balls that nearly hold each other.
std::vector<Hull> hulls() {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<Hull> list;
  for (int i = 0; i < 60; ++i) {
    const Vec3 a(0.6 * unit(random), 0.6 * unit(random), 0.6 * unit(random));
    const Vec3 b(0.6 * unit(random), 0.6 * unit(random), 0.6 * unit(random));
    const double length = glm::length(b - a), rb = i % 4 == 0 ? 0 : 0.2 * (1 + unit(random));
    const double sine = i % 3 == 0 ? 1 - std::pow(10, -1.5 * (i % 5)) : 0.5 * (1 + unit(random));
    list.push_back({a, b, rb + sine * length, rb});
    if (i % 2 == 0) std::swap(list.back().ra, list.back().rb);
  }
  return list;
}

TEST(AgreementConeSphere, EndsLieOnTheSurfaceAndNoneIsMissed) {
  int tips = 0, mantles = 0, missed = 0;
  for (const Hull& hull : hulls()) {
    scene::Scene scene;
    scene.width = scene.height = 12;
    scene.camera = {.eye = {0.3, 0.4, 4}, .fov = 25};
    scene.objects = {tapered_line({hull.a, hull.b}, {hull.ra, hull.rb})};
    const CrossingFinder finder(scene, Precision::exact);
    std::vector<Crossing> crossings;
    for (int y = 0; y < 12; ++y)
      for (int x = 0; x < 12; ++x) {
        const PictureRay ray = finder.frame().ray(x + 0.5, y + 0.5);
        finder.find(ray, crossings);
        const Vec3 direction = finder.frame().world_direction(ray);  // one unit of depth long
        const auto within = [&](double depth) {
          return depth_within(hull.a, hull.b, hull.ra, hull.rb,
                              scene.camera.eye + depth * direction);
        };
        if (crossings.empty()) {
          ++missed;
          ASSERT_LT(within(place_of_largest(1, 7, within)), 1e-12);
          continue;
        }
        ASSERT_EQ(crossings.size(), 2u);
        double middle = 0;
        for (const Crossing& c : crossings) {
          const double depth = c.depth / finder.frame().units_per_length();
          middle += 0.5 * depth;
          // Some ten roundings of numbers up to 6.
          ASSERT_NEAR(within(depth), 0, 1e-12);
          tips += std::lerp(hull.ra, hull.rb, c.u) < 0.05;
          mantles += c.u > 1e-3 && c.u < 1 - 1e-3;
          const Vec3 center = glm::mix(hull.a, hull.b, c.u);
          const double radius = std::lerp(hull.ra, hull.rb, c.u);
          if (radius < 1e-3) continue;
          const Vec3 normal = (scene.camera.eye + depth * direction - center) / radius;
          ASSERT_NEAR(glm::length(normal), 1, 1e-9);
          ASSERT_NEAR(c.v, glm::dot(normal, glm::normalize(direction)), 1e-9);
        }
        ASSERT_GT(within(middle), -1e-12);
      }
  }
  EXPECT_GT(mantles, 1000);
  EXPECT_GT(missed, 1000);
  EXPECT_GT(tips, 0);
}

// Rays along what generates the mantle, and nearly so: A of the quadratic vanishes.
TEST(AgreementConeSphere, RaysAlongTheMantleKeepTheirDigits) {
  const Hull hull{{0, 0, 0.7}, {0, 0, -0.7}, 0.6, 0.2};
  const double sine = 0.4 / 1.4, slope = sine / std::sqrt(1 - sine * sine);
  int found = 0;
  for (const double off : {0.0, 1e-16, 1e-12, 1e-8, 1e-4, -1e-12, -1e-4})
    for (const double side : {-0.3, -0.05, 0.0, 0.05, 0.3, 0.6}) {
      scene::Scene scene = orthographic_scene(9, 9);
      const Vec3 forward(-(slope + off), 0, -1);
      scene.camera.eye = Vec3(side, 0.03, 0) - 5.0 * glm::normalize(forward);
      scene.camera.target = Vec3(side, 0.03, 0);
      scene.objects = {tapered_line({hull.a, hull.b}, {hull.ra, hull.rb})};
      const CrossingFinder finder(scene, Precision::exact);
      std::vector<Crossing> crossings;
      for (int y = 0; y < 9; ++y) {
        const PictureRay ray = finder.frame().ray(4.5, y + 0.5);
        finder.find(ray, crossings);
        const double unit = finder.frame().units_per_length();
        const scene::CameraFrame& frame = finder.frame().camera();
        const Vec3 start = frame.eye + ray.x / unit * frame.right + ray.y / unit * frame.up;
        for (const Crossing& c : crossings) {
          const Vec3 x = start + c.depth / unit * frame.forward;
          EXPECT_NEAR(depth_within(hull.a, hull.b, hull.ra, hull.rb, x), 0, 1e-12);
          ++found;
        }
      }
    }
  EXPECT_GT(found, 100);
}

}  // namespace
}  // namespace pellucid::groundtruth
