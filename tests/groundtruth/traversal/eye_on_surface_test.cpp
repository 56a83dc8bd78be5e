// SPDX-License-Identifier: GPL-3.0-or-later
// What the eye lies on exactly is not seen, however the view is turned; an ulp further off it is.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "groundtruth/traversal/crossing_finder.h"
#include "tests/support/scenes.h"

namespace pellucid::groundtruth {
namespace {

using namespace testing;

/// Views from the eye whose axes no coordinate is parallel to.
std::vector<scene::Camera> turned_views(const Vec3& eye) {
  std::vector<scene::Camera> views;
  for (int i = 0; i < 12; ++i)
    views.push_back({.eye = eye,
                     .target = eye + Vec3(std::cos(i + 0.1), std::sin(i + 0.1), 0.3 * std::sin(i)),
                     .up = {0.1, 0.2, 1},
                     .fov = 60});
  return views;
}

/// How many crossings with the object the rays of a picture have.
std::size_t count(const scene::Scene& scene, std::uint32_t object = 0) {
  const CrossingFinder finder(scene, Precision::exact);
  std::vector<Crossing> crossings;
  std::size_t count = 0;
  for (int y = 0; y < scene.height; ++y)
    for (int x = 0; x < scene.width; ++x) {
      finder.find(finder.frame().ray(x + 0.5, y + 0.5), crossings);
      count += std::size_t(std::ranges::count(crossings, object, &Crossing::object));
    }
  return count;
}

/// 20 pixels high: of an odd number a row may run along the horizon.
scene::Scene scene_of(scene::SceneObject object) {
  scene::Scene scene;
  scene.width = scene.height = 20;
  scene.objects = {std::move(object)};
  return scene;
}

geometry::TriangleMesh triangle_at(double z) {
  geometry::TriangleMesh mesh;
  mesh.positions = {{-1e6, -1e6, z}, {1e6, -1e6, z}, {0, 1e6, z}};
  mesh.triangles = {{0, 1, 2}};
  mesh.colors.assign(3, Rgba(0.5));
  mesh.normals.assign(3, Vec3(0, 0, 1));
  return mesh;
}

TEST(PropertyEyeOnSurface, ATriangleThatTheEyeLiesInIsNotSeen) {
  scene::Scene scene = scene_of({"", triangle_at(0.1)});
  for (const scene::Camera& camera : turned_views({0.2, 0.3, 0.1})) {
    scene.camera = camera;
    EXPECT_EQ(count(scene), 0u);
  }
}

TEST(PropertyEyeOnSurface, AnUlpBesideATriangleHalfOfAllIsIt) {
  // The triangle is seen below the horizon: as often as from far above it, where rays are the same.
  scene::Scene scene = scene_of({"", triangle_at(0.1)});
  for (const scene::Camera& camera : turned_views({0.2, 0.3, std::nextafter(0.1, 1)})) {
    scene.camera = camera;
    const std::size_t near = count(scene);
    scene.camera.eye.z += 0.5;
    scene.camera.target.z += 0.5;
    EXPECT_EQ(near, count(scene));
    EXPECT_GT(near, 0u);
  }
}

TEST(PropertyEyeOnSurface, AnOpaqueTriangleThatTheEyeLiesInHidesNothing) {
  scene::Scene scene = scene_of({"", triangle_at(0.1)});
  scene.objects[0].opaque = true;
  scene.objects.push_back({"", sphere(3, Rgba(0.5))});
  for (const scene::Camera& camera : turned_views({0.2, 0.3, 0.1})) {
    scene.camera = camera;
    EXPECT_EQ(count(scene, 1), 400u);  // the eye is within the sphere
  }
}

/// Exactly 0.28125 from the origin.
constexpr Vec3 eye{0.28125, 0, 0};

scene::SceneObject ball(double radius) {
  scene::PointObject points;
  points.set.positions = {Vec3(0)};
  points.set.colors = {Rgba(0.5)};
  points.radius = radius;
  points.profile = scene::PointObject::Profile::sphere;
  return {"", points};
}

scene::SceneObject tube(double radius) {
  scene::LineObject line{{}, radius, scene::LineObject::Profile::tube};
  line.set.positions = {{0, 0, -2}, {0, 0, 0.5}, {0, 0, 2}};
  line.set.offsets = {0, 3};
  line.set.colors.assign(3, Rgba(0.5));
  return {"", line};
}

TEST(PropertyEyeOnSurface, ARoundSolidThatTheEyeLiesOnIsLeftOnly) {
  const double on = eye.x, beyond = std::nextafter(on, 1), before = std::nextafter(on, 0);
  for (const auto& solid : {ball, tube})
    for (const double up : {0.1, 0.7, 1.3, 2.9}) {
      scene::Camera inwards{
          .eye = eye, .target = {0.01, 0.02, 0.03}, .up = {0.1, up, 1}, .fov = 10};
      scene::Camera outwards = inwards;
      outwards.target = 2.0 * eye - inwards.target;
      const auto found = [&](double radius, const scene::Camera& camera) {
        scene::Scene scene = scene_of(solid(radius));
        scene.camera = camera;
        return count(scene);
      };
      // 400 rays: from the surface or within one crossing each, from outside two.
      EXPECT_EQ(found(on, inwards), 400u);
      EXPECT_EQ(found(beyond, inwards), 400u);
      EXPECT_EQ(found(before, inwards), 800u);
      EXPECT_EQ(found(on, outwards), 0u);
      EXPECT_EQ(found(beyond, outwards), 400u);
      EXPECT_EQ(found(before, outwards), 0u);
    }
}

/// From radius 1/2 at the origin to 1/8 at z = 5/8: its mantle leans by the angle β of sin β = 3/5.
scene::SceneObject cone_sphere() {
  scene::LineObject line;
  line.radius = scene::Radii(std::vector{0.5, 0.125});
  line.profile = scene::LineObject::Profile::tube;
  line.set.positions = {{0, 0, 0}, {0, 0, 0.625}};
  line.set.offsets = {0, 2};
  line.set.colors.assign(2, Rgba(0.5));
  return {"", line};
}

// The ball of radius 5/16 around z = 5/16 touches the mantle at 5/16 (4/5, 0, 3/5) from there,
// whose coordinates are doubles.
TEST(PropertyEyeOnSurface, AConeSphereThatTheEyeLiesOnIsLeftOnly) {
  const Vec3 on(0.25, 0, 0.5);
  const Vec3 steps[] = {Vec3(0), Vec3(std::nextafter(0.25, 0) - 0.25, 0, 0),
                        Vec3(std::nextafter(0.25, 1) - 0.25, 0, 0)};
  for (const double up : {0.1, 0.7, 1.3, 2.9})
    for (int step = 0; step < 3; ++step) {
      const Vec3 eye = on + steps[step];
      const Vec3 inside(0.01, 0.02, 0.33);
      scene::Scene scene = scene_of(cone_sphere());
      scene.camera = {.eye = eye, .target = inside, .up = {0.1, up, 1}, .fov = 10};
      EXPECT_EQ(count(scene), step == 2 ? 800u : 400u) << step;
      scene.camera.target = 2.0 * eye - inside;
      EXPECT_EQ(count(scene), step == 1 ? 400u : 0u) << step;
    }
}

}  // namespace
}  // namespace pellucid::groundtruth
