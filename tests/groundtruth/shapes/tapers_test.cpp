// SPDX-License-Identifier: GPL-3.0-or-later
// Radii that differ from point to point: discs, spheres, ribbons that narrow, and tubes, whose
// segments are hulls of two balls.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "groundtruth/traversal/crossing_finder.h"
#include "tests/support/scenes.h"

namespace pellucid::groundtruth {
namespace {

using namespace testing;
using LineProfile = scene::LineObject::Profile;
using PointProfile = scene::PointObject::Profile;

scene::SceneObject tapered_line(const std::vector<Vec3>& points, std::vector<double> radii,
                                LineProfile profile = LineProfile::tube) {
  scene::LineObject object;
  object.radius = scene::Radii(std::move(radii));
  object.profile = profile;
  object.set.positions = points;
  object.set.offsets = {0, points.size()};
  for (std::size_t i = 0; i < points.size(); ++i)
    object.set.colors.emplace_back(float(i) / float(points.size() - 1), 0, 0, 0.5f);
  return {"line", object};
}

/// Calls see(x, y, crossings) for the rays of all pixels; lengths in depths are the world's.
template <class See>
void see_all(const scene::Scene& scene, const See& see) {
  const CrossingFinder finder(scene, Precision::exact);
  std::vector<Crossing> crossings;
  for (int y = 0; y < scene.height; ++y)
    for (int x = 0; x < scene.width; ++x) {
      finder.find(finder.frame().ray(x + 0.5, y + 0.5), crossings);
      for (Crossing& c : crossings) c.depth /= finder.frame().units_per_length();
      see(x, y, crossings);
    }
}

/// Of one pixel, in the middle, seen along -z from z = 5.
std::vector<Crossing> seen_in_the_middle(const scene::SceneObject& object) {
  scene::Scene scene = orthographic_scene(1, 1);
  scene.objects = {object};
  std::vector<Crossing> found;
  see_all(scene, [&](int, int, const std::vector<Crossing>& c) { found = c; });
  return found;
}

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
  scene::PointObject ball{{}, 0.8, PointProfile::sphere};
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

/// Where a concave function of [low, high] is largest, to 1e-10 of the range.
template <class Function>
double place_of_largest(double low, double high, const Function& function) {
  for (int i = 0; i < 57; ++i) {
    const double p = std::lerp(low, high, 1.0 / 3), q = std::lerp(low, high, 2.0 / 3);
    (function(p) < function(q) ? low : high) = function(p) < function(q) ? p : q;
  }
  return 0.5 * (low + high);
}

/// The largest of r(s) - |x - c(s)| over the balls of a segment, s in [0, 1]: above 0 within the
/// hull. It is concave in s, and the largest is concave in x.
double depth_within(const Vec3& a, const Vec3& b, double ra, double rb, const Vec3& x) {
  const auto depth = [&](double s) {
    return std::lerp(ra, rb, s) - glm::length(x - glm::mix(a, b, s));
  };
  return std::max({depth(0), depth(1), depth(place_of_largest(0, 1, depth))});
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
