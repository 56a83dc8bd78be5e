// SPDX-License-Identifier: GPL-3.0-or-later
// A scene that turns is drawn as one that was loaded for each camera, rows of a picture as all of
// it, to the last bit.
#include <gtest/gtest.h>

#include "core/error.h"
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

/// Also rows that part the packets of rays, which are four rows high.
TEST(UnitRows, AreThoseOfTheWholePicture) {
  scene::Scene scene = all_shapes();
  scene.samples = {.per_axis = 2};
  const auto raytracer = make_raytracer(scene, {});
  const scene::Rendering whole = raytracer->render({.layers = true});
  for (const int rows : {1, 7, 16, 30, 64}) {
    Image joined(scene.width, 0);
    const scene::RenderStats stats = raytracer->render_rows(
        rows,
        [&](int first, const Image& part) {
          EXPECT_EQ(first, int(joined.pixels.size()) / scene.width);
          EXPECT_EQ(part.height, std::min(rows, scene.height - first));
          joined.pixels.insert(joined.pixels.end(), part.pixels.begin(), part.pixels.end());
        },
        {});
    EXPECT_TRUE(joined.pixels == whole.image.pixels) << rows;
    EXPECT_EQ(stats.fragments, whole.stats.fragments);
    EXPECT_EQ(stats.max_layers, whole.stats.max_layers);
  }
}

TEST(UnitRows, AreNotSampledAdaptively) {
  const scene::Scene scene = all_shapes();
  const auto raytracer = make_raytracer(scene, {.adaptive = 3});
  EXPECT_THROW(raytracer->render_rows(8, [](int, const Image&) {}, {}), InputError);
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
