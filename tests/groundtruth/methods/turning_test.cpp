// SPDX-License-Identifier: GPL-3.0-or-later
// A scene that turns is drawn as one that was loaded for each camera, to the last bit.
#include <gtest/gtest.h>

#include "groundtruth/methods/raytrace.h"
#include "scene/halo.h"
#include "tests/support/scenes.h"

namespace pellucid::groundtruth {
namespace {

scene::Scene all_shapes() {
  scene::Scene scene = testing::empty_scene(40, 30);
  scene.camera = {};
  scene.objects.push_back({"triangles", testing::random_triangles(60, 1)});
  scene.objects.push_back({"needles", testing::random_triangles(20, 2, 0.1)});
  scene.objects.push_back({"sphere", testing::sphere(2, {0.2, 0.6, 0.4, 0.3})});
  scene::LineObject lines;
  lines.set.positions = {{-1, -1, 0}, {0, 0.5, 0.5}, {1, -0.5, -0.5}};
  lines.set.colors.assign(3, Rgba(0.9, 0.1, 0.1, 0.6));
  lines.set.offsets = {0, 3};
  lines.radius = 0.1;
  lines.halo = scene::Halo{0.1, 0.1, std::nullopt};
  scene.objects.push_back({"ribbon", lines});
  lines.halo.reset();
  lines.profile = scene::LineObject::Profile::tube;
  scene.objects.push_back({"tube", lines});
  scene::PointObject points;
  points.set.positions = {{0.5, 0.5, 0.5}, {-0.5, 0.2, 0}};
  points.set.colors.assign(2, Rgba(0.1, 0.1, 0.9, 0.5));
  points.radius = 0.3;
  points.profile = scene::PointObject::Profile::sphere;
  scene.objects.push_back({"spheres", points});
  scene::place_halos(scene);
  return scene;
}

void look_from(const Vec3& eye, int samples, scene::Scene& scene) {
  scene.camera.eye = eye;
  scene.samples = {.per_axis = samples};
  scene.width = 40 + samples;
  scene::place_halos(scene);
}

TEST(UnitTurning, IsTheSameToTheLastBit) {
  scene::Scene turns = all_shapes();
  const auto turning = make_turning_raytracer(turns, {});
  turning->render({});
  for (const Vec3& eye : {Vec3(0, 0, 5), Vec3(4, 1, 2), Vec3(-2, 3, -4), Vec3(0, -6, 0.1)}) {
    look_from(eye, eye.x > 0 ? 2 : 1, turns);
    turning->turn();
    scene::Scene anew = all_shapes();
    look_from(eye, eye.x > 0 ? 2 : 1, anew);
    const scene::Rendering seen = turning->render({.layers = true});
    const scene::Rendering expected = make_raytracer(anew, {})->render({.layers = true});
    EXPECT_TRUE(seen.image.pixels == expected.image.pixels) << eye.x;
    EXPECT_TRUE(seen.layers.pixels == expected.layers.pixels) << eye.x;
    EXPECT_GT(expected.stats.max_layers, 5u);
  }
}

}  // namespace
}  // namespace pellucid::groundtruth
