// SPDX-License-Identifier: GPL-3.0-or-later
// What every row of the method table does with depths: scenes that are thin, far away, or seen in
// part, and layers of equal depth.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "compare/methods/methods.h"
#include "tests/compare/methods/promise_scenes.h"

namespace pellucid::compare {
namespace {

using namespace testing;

/// An orthographic cloud of a cube's size before an eye at distance 5.
scene::Scene cube_cloud(unsigned seed) {
  scene::Scene scene = empty_scene(32, 32);
  for (unsigned i = 0; i < 4; ++i)
    scene.objects.push_back({"cloud", random_triangles(5, 4 * seed + i)});
  return scene;
}

/// The scene with its depths, from z = -1 to 1, times `thickness`, seen from so far away.
scene::Scene flattened(scene::Scene scene, double thickness, double distance) {
  scene.camera.eye = {0, 0, distance};
  for (scene::SceneObject& object : scene.objects)
    for (Vec3& x : object.vertices().positions) x.z *= 0.5 * thickness * distance;
  return scene;
}

// Parallel rays do not see how far away the layers are, or how near each other.
TEST(PropertyDepth, ThinScenesLookAsThickOnes) {
  const scene::Scene scene = cube_cloud(1);
  for (const scene::MethodRow& row : methods()) {
    const Image thick = render(row, scene).image;
    for (const double thickness : {1e-3, 1e-6, 1e-7, 1e-9})
      for (const double distance : {1.0, 1e7}) {
        SCOPED_TRACE(::testing::Message() << row.name << ' ' << thickness << ' ' << distance);
        expect_same(row, thick, render(row, flattened(scene, thickness, distance)).image);
      }
  }
}

// Seen from 1e7 away through a telescope, rays are parallel up to 1e-7.
TEST(PropertyDepth, ADistantEyeSeesTheSameLayers) {
  const scene::Scene scene = cube_cloud(2);
  for (const scene::MethodRow& row : methods()) {
    const Image parallel = render(row, scene).image;
    for (const double distance : {1e6, 1e7, 1e8}) {
      scene::Scene distant = scene;
      distant.camera = {.eye = {0, 0, distance},
                        .fov = 360 / std::numbers::pi * std::atan(1 / distance)};
      SCOPED_TRACE(::testing::Message() << row.name << ' ' << distance);
      expect_same(row, parallel, render(row, distant).image);
    }
  }
}

/// Sheets between z = 1 and -1 of the camera's default view, and something in a corner that is not
/// in the picture.
scene::Scene with_something_aside(const Vec3& where) {
  scene::Scene scene = stack(4, 4, random_layers(8, 0.6f, 4));
  scene.camera = {};
  scene.objects.push_back(
      {"aside", rectangle(where.x, where.x + 1e-3, where.y, where.y + 1e-3, where.z, Rgba(1))});
  return scene;
}

TEST(PropertyDepth, WhatIsNotInThePictureDoesNotChangeIt) {
  scene::Scene alone = with_something_aside({0, 0, 0});
  alone.objects.pop_back();
  for (const scene::MethodRow& row : methods()) {
    const Image expected = render(row, alone).image;
    for (const Vec3& where : {Vec3(1, 0, 5 - 1e-6), Vec3(1e9, 0, -1e8), Vec3(0, 0, 1e9)}) {
      SCOPED_TRACE(::testing::Message() << row.name << ' ' << where.x << ' ' << where.z);
      // View units are the same: so is every bit.
      EXPECT_EQ(largest_difference(render(row, with_something_aside(where)).image, expected), 0);
    }
  }
}

// Near the eye: what a millionth and a thousand millionth of the far end's depth away is.
TEST(PropertyDepth, WhatIsNearTheEyeIsNotLost) {
  const std::vector<Rgba> layers = {{0.2f, 0.4f, 0.8f, 0.5f}, {0.9f, 0.1f, 0.3f, 0.5f}};
  for (const double near : {1e-5, 1e-7, 1e-9, 1e-12}) {
    scene::Scene scene = stack(4, 4, layers);
    scene.camera = {.eye = {0, 0, 0}, .target = {0, 0, -1}};
    scene.objects[0].shape = rectangle(-near, near, -near, near, -near, layers[0]);
    scene.objects[1].shape = rectangle(-1, 1, -1, 1, -1, layers[1]);
    for (const scene::MethodRow& row : methods()) {
      if (!is_exact(row)) continue;
      EXPECT_LE(largest_difference(render(row, scene).image, composite(layers, scene.background)),
                float_composite)
          << row.name << ' ' << near;
    }
  }
}

/// Sheets at one depth; those numbers are opaque objects.
scene::Scene coplanar(const std::vector<Rgba>& layers, const std::vector<int>& opaque) {
  scene::Scene scene = stack(4, 4, layers);
  for (scene::SceneObject& object : scene.objects)
    for (Vec3& x : object.mesh().positions) x.z = 0.5;
  for (const int i : opaque) scene.objects[std::size_t(i)].opaque = true;
  return scene;
}

// Of equal depths the object that comes first is in front, and hides the rest if it is opaque.
TEST(PropertyDepth, EqualDepthsAreOrderedByObjectAlsoWhereOneIsOpaque) {
  const std::vector<Rgba> layers = random_layers(6, 0.7f, 5);
  for (const std::vector<int>& opaque :
       {std::vector<int>{}, {0}, {1}, {2}, {4}, {5}, {1, 3}, {2, 5}}) {
    const scene::Scene scene = coplanar(layers, opaque);
    std::vector<Rgba> seen = layers;
    if (!opaque.empty()) {
      seen.resize(std::size_t(opaque.front()) + 1);
      seen.back().a = 1;
    }
    for (const scene::MethodRow& row : methods()) {
      if (!is_exact(row)) continue;
      EXPECT_LE(largest_difference(render(row, scene).image, composite(seen, scene.background)),
                float_composite)
          << row.name << " opaque from " << (opaque.empty() ? -1 : opaque.front());
    }
  }
}

// Two objects or one of both their primitives, in front of an opaque one.
TEST(PropertyDepth, EqualDepthsAreOrderedByPrimitiveWithinAnObject) {
  const std::vector<Rgba> layers = random_layers(5, 0.7f, 6);
  scene::Scene scene = coplanar(layers, {3});
  scene::Scene merged = scene;
  geometry::TriangleMesh& mesh = merged.objects[0].mesh();
  const geometry::TriangleMesh& second = scene.objects[1].mesh();
  for (std::size_t i = 0; i < 4; ++i) {
    mesh.positions.push_back(second.positions[i]);
    mesh.colors.push_back(second.colors[i]);
    mesh.normals.push_back(second.normals[i]);
  }
  for (const auto& [a, b, c] : second.triangles) mesh.triangles.push_back({4 + a, 4 + b, 4 + c});
  merged.objects.erase(merged.objects.begin() + 1);
  for (const scene::MethodRow& row : methods()) {
    if (!is_exact(row)) continue;
    EXPECT_EQ(largest_difference(render(row, scene).image, render(row, merged).image), 0)
        << row.name;
  }
}

}  // namespace
}  // namespace pellucid::compare
