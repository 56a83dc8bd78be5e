// SPDX-License-Identifier: GPL-3.0-or-later
// The depth range is that of what is in the picture, whatever the shape and however thin.
#include "scene/view_depth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/error.h"
#include "scene/view/picture_frustum.h"
#include "tests/support/scenes.h"

namespace pellucid::scene {
namespace {

using namespace pellucid::testing;

// The margins are a 1e-5th of the length, and 2 % above it for the bounds' own rounding.
constexpr double margin = 1.02e-5;

void expect_range(const Scene& scene, double near, double far) {
  const DepthRange range = depth_range(scene);
  const double length = far - near;
  EXPECT_NEAR(range.near, near, margin * length);
  EXPECT_NEAR(range.far, far, margin * length);
  EXPECT_LT(range.near, near);
  EXPECT_GT(range.far, far);
}

Scene perspective_scene() {
  Scene scene = empty_scene(8, 8);
  scene.camera = {.eye = {0, 0, 0}, .target = {0, 0, -1}, .fov = 90};
  return scene;
}

SceneObject points_at(const Vec3& x, double radius, PointObject::Profile profile) {
  PointObject points;
  points.radius = radius;
  points.profile = profile;
  points.set.positions = {x};
  points.set.colors = {Rgba(1)};
  return {"points", points};
}

SceneObject line(const std::vector<Vec3>& points, double radius, LineObject::Profile profile) {
  LineObject lines;
  lines.radius = radius;
  lines.profile = profile;
  lines.set.positions = points;
  lines.set.colors.assign(points.size(), Rgba(1));
  lines.set.offsets = {0, std::uint32_t(points.size())};
  return {"lines", lines};
}

// At fov 90° a floor at y = -1 enters the picture at z = 1.
TEST(UnitViewDepth, AFloorBeginsAtThePicturesLowerEdge) {
  Scene scene = perspective_scene();
  SceneObject floor = sheet(0, Rgba(1));
  floor.mesh().positions = {Vec3(-900, -1, 50), Vec3(900, -1, 50), Vec3(900, -1, -100),
                            Vec3(-900, -1, -100)};
  scene.objects = {floor};
  expect_range(scene, 1, 100);
}

TEST(UnitViewDepth, WhatIsOutsideOfThePictureDoesNotCount) {
  using enum PointObject::Profile;
  using enum LineObject::Profile;
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    Scene scene = perspective_scene();
    scene.camera.projection = projection;
    scene.objects = {sheet(-4, Rgba(1)), sheet(-5, Rgba(1))};
    const Vec3 aside(-200, 0, -100), above(0, 0.45, -0.1), behind(0, 0, 3);
    for (const Vec3& x : {aside, projection == Projection::perspective ? above : aside, behind}) {
      scene.objects.push_back(points_at(x, 0.1, disc));
      scene.objects.push_back(points_at(x, 0.1, sphere));
      scene.objects.push_back(line({x, x + Vec3(0, 0.1, 0)}, 0.01, ribbon));
      scene.objects.push_back(line({x, x + Vec3(0, 0.1, 0)}, 0.01, tube));
      scene.objects.push_back({"mesh", rectangle(x.x, x.x + 1, x.y, x.y + 1, x.z, Rgba(1))});
      Isosurface surface;
      surface.corners = corners_of({x, x + Vec3(1, 1, 0.01)});
      scene.objects.push_back({"isosurface", surface});
    }
    expect_range(scene, 4, 5);
  }
}

// A file whose points lie elsewhere is named.
TEST(UnitViewDepth, WhatIsNotInFrontIsNamed) {
  Scene scene = perspective_scene();
  for (const char* name : {"a.ply", "b.csv", "c.obj", "d.vtp"})
    scene.objects.push_back({name, rectangle(0, 1, 0, 1, 3, Rgba(1))});
  scene.provenance["b.csv"] = "points of wake.csv";
  try {
    depth_range(scene);
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what())
                  .find("nothing of a.ply, b.csv (points of wake.csv), c.obj and 1 more is in"),
              std::string::npos)
        << error.what();
  }
}

// The range of all that is in front: a picture of nothing is still a picture.
TEST(UnitViewDepth, NothingInThePictureIsNoError) {
  Scene scene = perspective_scene();
  scene.objects = {{"left", rectangle(-200, -199, 0, 1, -3, Rgba(1))},
                   {"right", rectangle(199, 200, 0, 1, -7, Rgba(1))}};
  expect_range(scene, 3, 7);
}

TEST(UnitViewDepth, DepthsNextToTheEyeKeepTheirDigits) {
  Scene scene = perspective_scene();
  scene.objects = {sheet(-1e-9, Rgba(1)), sheet(-1e9, Rgba(1))};
  const DepthRange range = depth_range(scene);
  EXPECT_GT(range.near, 0);
  EXPECT_LT(range.near, 1e-9);
  EXPECT_GT(float(range.normalized(1e-9)), 0.f);
}

// Thickness over distance from the eye; a double has 1e-16.
TEST(UnitViewDepth, AThinSceneHasAllOfTheRange) {
  for (const double distance : {1e-7, 1.0, 1e7})
    for (const double thickness : {1e-3, 1e-6, 1e-9, 1e-12}) {
      Scene scene = stack(3, 4, 4, [](int) { return Rgba(1); });
      scene.camera.eye = {0, 0, distance};
      scene.camera.height = 2 * distance;
      for (SceneObject& object : scene.objects)
        for (Vec3& x : object.mesh().positions) x.z *= 0.5 * thickness * distance;
      const DepthRange range = depth_range(scene);
      for (const int i : {0, 1, 2}) {
        const double z = distance - scene.objects[std::size_t(i)].mesh().positions[0].z;
        // A rounding of z, at most 1.2e-16 of the distance, on either side; and the margins.
        EXPECT_NEAR(range.normalized(z), 0.5 * i, 2.4e-16 / thickness + margin) << thickness;
      }
    }
}

// A plane that faces a camera in any direction has one depth but for rounding.
TEST(PropertyViewDepth, RoundingIsNoThickness) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int n = 0; n < 1000; ++n) {
    Scene scene = empty_scene(8, 8);
    const Vec3 center(1e3 * unit(random), unit(random), unit(random));
    scene.camera.eye = Vec3(unit(random), unit(random), unit(random));
    scene.camera.target = center;
    const CameraFrame frame = camera_frame(scene.camera);
    SceneObject plane = sheet(0, Rgba(1));
    for (Vec3& x : plane.mesh().positions) x = center + 0.02 * (x.x * frame.right + x.y * frame.up);
    scene.objects = {plane};
    EXPECT_NEAR(depth_range(scene).normalized(view_depth(frame, center)), 0.5, 1e-12);
  }
}

/// Depths of points of a triangle that rays through the picture meet: along its edges, and where
/// the rays through the picture's corners meet it (by Cramer's rule). The extremes are among them.
DepthInterval sampled_depths(const Scene& scene, const std::vector<Vec3>& corners, int n) {
  const RayGenerator rays(scene.camera, scene.width, scene.height);
  const Vec2 half(half_height(scene.camera) * scene.width / scene.height,
                  half_height(scene.camera));
  const bool perspective = scene.camera.projection == Projection::perspective;
  DepthInterval seen;
  for (int edge = 0; edge < 3; ++edge)
    for (int i = 0; i <= n; ++i) {
      const Vec3& a = corners[std::size_t(edge)];
      const Vec3 x = a + double(i) / n * (corners[std::size_t(edge + 1) % 3] - a);
      const double z = view_depth(rays.frame(), x), scale = perspective ? z : 1;
      if (z > 0 && std::abs(x.x) <= scale * half.x && std::abs(x.y) <= scale * half.y)
        seen.extend({z, z});
    }
  for (const auto& [px, py] : {std::pair(0, 0), {0, 1}, {1, 0}, {1, 1}}) {
    const Ray ray = rays.ray(px * scene.width, py * scene.height);
    const Mat3 m(corners[1] - corners[0], corners[2] - corners[0], -ray.direction);
    const Vec3 at = glm::inverse(m) * (ray.origin - corners[0]);
    if (at.x >= 0 && at.y >= 0 && at.x + at.y <= 1 && at.z > 0) seen.extend({at.z, at.z});
  }
  return seen;
}

TEST(PropertyViewDepth, BoundsHoldWhatRaysSeeAndNothingElse) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> unit(-1, 1);
  int seen_triangles = 0;
  for (int n = 0; n < 200; ++n) {
    Scene scene = perspective_scene();
    scene.width = 12;
    if (n % 2) scene.camera.projection = Projection::orthographic;
    SceneObject triangle = sheet(0, Rgba(1));
    auto& x = triangle.mesh().positions;
    x = {Vec3(3 * unit(random), 3 * unit(random), 4 * unit(random)),
         Vec3(3 * unit(random), 3 * unit(random), 4 * unit(random)),
         Vec3(3 * unit(random), 3 * unit(random), 4 * unit(random))};
    // Across the eye's plane a perspective picture has no width: there no sample is missed.
    if (n % 2)
      for (Vec3& corner : x) corner.z = -std::abs(corner.z);
    triangle.mesh().triangles = {{0, 1, 2}};
    scene.objects = {triangle};
    const DepthInterval seen = sampled_depths(scene, x, 4000);
    if (seen.empty()) continue;
    ++seen_triangles;
    const DepthRange range = depth_range(scene);
    // Of the ends found on edges up to 8 long, 1 / 4000 of it; the margins of a range up to 4 long.
    constexpr double tolerance = 2.1e-3;
    EXPECT_LE(range.near, seen.min + 1e-12) << n;
    EXPECT_GE(range.far, seen.max - 1e-12) << n;
    EXPECT_GE(range.near, seen.min - tolerance) << n;
    EXPECT_LE(range.far, seen.max + tolerance) << n;
  }
  EXPECT_GT(seen_triangles, 50);
}

}  // namespace
}  // namespace pellucid::scene
