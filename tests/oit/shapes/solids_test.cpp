// SPDX-License-Identifier: GPL-3.0-or-later
// What is drawn around spheres and tubes holds all of them, and not much more; which parts of a
// tube overlap is what brute force finds.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "oit/shapes/solid/solid_bounds.h"
#include "oit/shapes/solid/tube_overlaps.h"
#include "scene/view_depth.h"
#include "tests/support/scenes.h"

namespace pellucid::oit {
namespace {

using namespace pellucid::testing;

/// 80 × 60 pixels; the eye sees along -z, or from the origin of the view frame.
ViewSpace view_of(scene::Projection projection) {
  scene::Scene scene = empty_scene(80, 60);
  scene.camera.projection = projection;
  scene.objects = {sheet(1, Rgba(1)), sheet(-1, Rgba(1))};
  return {scene, scene::depth_range(scene)};
}

/// A ray of view coordinates, through a point as PictureRectangle has them.
struct ViewRay {
  Vec3 start, direction;
};

ViewRay ray_of(const Vec2& point, scene::Projection projection) {
  if (projection == scene::Projection::orthographic) return {Vec3(point, 0), Vec3(0, 0, 1)};
  return {Vec3(0), glm::normalize(Vec3(point, 1))};
}

/// By steps along the segment: does the ray meet a ball of it, in front of the eye?
bool meets(const ViewRay& ray, const ConeSphere& solid) {
  for (int i = 0; i <= 100; ++i) {
    const Vec3 to = glm::mix(solid.a, solid.b, i / 100.0) - ray.start;
    const double radius = glm::mix(solid.radius_a, solid.radius_b, i / 100.0);
    const double along = glm::dot(to, ray.direction);
    const double away = glm::length(to - along * ray.direction);
    if (away < radius && along + std::sqrt((radius - away) * (radius + away)) > 0) return true;
  }
  return false;
}

bool holds(const PictureRectangle& rectangle, const Vec2& p) {
  const double first = glm::dot(p, rectangle.axis);
  const double second = glm::dot(p, Vec2(-rectangle.axis.y, rectangle.axis.x));
  return rectangle.first.x <= first && first <= rectangle.first.y && rectangle.second.x <= second &&
         second <= rectangle.second.y;
}

/// Where the pixel's centre is seen, as PictureRectangle has it.
Vec2 seen_at(const ViewSpace& view, int x, int y) {
  return (2.0 * Vec2(x + 0.5, y + 0.5) / view.size() - 1.0) / view.clip_scale();
}

/// Pixels whose rays meet the solid, and those in its rectangle; every one of the former is
/// there.
struct Covered {
  int met = 0, drawn = 0;
};

Covered covered(const ViewSpace& view, const ConeSphere& solid) {
  const PictureRectangle rectangle = bounds_in_picture(solid, view);
  Covered count;
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 80; ++x) {
      const Vec2 p = seen_at(view, x, y);
      const bool met = meets(ray_of(p, view.projection()), solid);
      count.met += met;
      count.drawn += holds(rectangle, p);
      EXPECT_TRUE(!met || holds(rectangle, p)) << x << ' ' << y;
    }
  return count;
}

/// Of sizes from a hundredth to three times the distance, on all sides of the eye and around it.
ConeSphere random_solid(std::mt19937& random, bool sphere) {
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto any = [&] { return Vec3(unit(random), unit(random), unit(random)); };
  const Vec3 a = any();
  const double radius = std::pow(10, -0.75 + 1.25 * unit(random));
  // Half of the others taper, many to a tip.
  const double other = sphere ? radius : radius * std::clamp(1.5 + 2 * unit(random), 0.0, 1.0);
  return {a, sphere ? a : any(), radius, other};
}

TEST(PropertySolidBounds, EveryRayThatMeetsIsWithin) {
  for (const auto projection : {scene::Projection::perspective, scene::Projection::orthographic}) {
    const ViewSpace view = view_of(projection);
    std::mt19937 random(1);
    int met = 0, empty = 0;
    for (int n = 0; n < 600; ++n) {
      const ConeSphere solid = random_solid(random, n % 2 == 0);
      met += covered(view, solid).met > 0;
      empty += bounds_in_picture(solid, view).empty();
    }
    EXPECT_GT(met, 100);
    EXPECT_GT(empty, 50);
  }
}

// A circle has π/4 of its square. An ellipse, or a rectangle with round ends, has more.
TEST(PropertySolidBounds, LittleElseIsDrawn) {
  for (const auto projection : {scene::Projection::perspective, scene::Projection::orthographic}) {
    const ViewSpace view = view_of(projection);
    // An eighth of a pixel around a circle of 18 takes a fiftieth of it.
    const double radius = projection == scene::Projection::perspective ? 0.1 : 0.3;
    for (const Vec3& end : {Vec3(0, 0, 0.8), Vec3(0.2, 0.15, 0.7), Vec3(-0.2, 0.2, 0.9)}) {
      const Covered count = covered(view, {{0, 0, 0.8}, end, radius, radius});
      EXPECT_GT(count.met, 100);
      EXPECT_LE(count.drawn, 1.1 * 4 / 3.14159 * count.met) << end.x;
    }
  }
}

std::vector<Vec3> random_walk(int points, double step, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<Vec3> line{Vec3(0)};
  while (int(line.size()) < points)
    line.push_back(line.back() + step * Vec3(unit(random), unit(random), unit(random)));
  return line;
}

/// What lies between the balls of two segments, of 17 on each, so never less than it is.
double sampled_gap(std::span<const Vec3> line, scene::RadiusSpan radius, std::uint32_t p,
                   std::uint32_t q) {
  double least = 1e9;
  for (int i = 0; i <= 16; ++i)
    for (int j = 0; j <= 16; ++j) {
      const double s = i / 16.0, t = j / 16.0;
      const double apart =
          glm::length(glm::mix(line[p], line[p + 1], s) - glm::mix(line[q], line[q + 1], t));
      least = std::min(least, apart - std::lerp(radius.at(p), radius.at(p + 1), s) -
                                  std::lerp(radius.at(q), radius.at(q + 1), t));
    }
  return least;
}

/// Boxes of a sixteenth of a segment bring `most` times as many as there are, at most.
void expect_all_overlaps(std::span<const Vec3> line, scene::RadiusSpan radius, double most) {
  std::set<SegmentPair> found;
  for (const SegmentPair& pair : overlapping_segments(line, radius, 100000)) {
    EXPECT_LT(pair.first, pair.second);
    EXPECT_TRUE(found.insert(pair).second) << "twice";
  }
  std::size_t near = 0;
  for (std::uint32_t p = 0; p + 1 < line.size(); ++p)
    for (std::uint32_t q = p + 1; q + 1 < line.size(); ++q)
      if (sampled_gap(line, radius, p, q) <= 0) {
        ++near;
        EXPECT_TRUE(found.contains({p, q})) << p << ' ' << q;
      }
  EXPECT_GT(near, 400u);
  EXPECT_LE(double(found.size()), most * double(near));
}

TEST(AgreementTubeOverlaps, AllThatComeNearAndFewOthers) {
  const std::vector<Vec3> line = random_walk(300, 0.2, 5);
  expect_all_overlaps(line, 0.06, 1.15);
  std::vector<double> radii;
  for (std::size_t i = 0; i < line.size(); ++i) radii.push_back(0.03 * double(i % 5));
  expect_all_overlaps(line, scene::RadiusSpan(radii), 1.25);
}

TEST(UnitTubeOverlaps, OneMoreThanTheMostSaysThatThereAreMore) {
  const std::vector<Vec3> line = random_walk(300, 0.01, 6);
  EXPECT_EQ(overlapping_segments(line, 1, 1000).size(), 1001u);
  EXPECT_TRUE(overlapping_segments(std::span(line).first(2), 1, 10).empty());
  EXPECT_EQ(overlapping_segments(std::span(line).first(3), 1, 10).size(), 1u);
}

}  // namespace
}  // namespace pellucid::oit
