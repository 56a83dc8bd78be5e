// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of marched isosurfaces: closed forms, and agreement with exact crossings.

#include "groundtruth/methods/march.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "groundtruth/methods/raytrace.h"
#include "scene/appearance/colormap.h"
#include "tests/groundtruth/levels.h"
#include "tests/support/pictures.h"
#include "tests/support/scenes.h"

namespace pellucid::groundtruth {
namespace {

using testing::largest_difference;

/// The surface x² + y² + z² = 4, drawn from the front, and a ball within that hides what is behind.
scene::Scene balls(bool opaque) {
  scene::Scene scene;
  scene.width = 24;
  scene.height = 18;
  scene.camera.eye = Vec3(1, 2, -12);
  scene.lighting = scene::Lighting::headlight;
  const auto square = [](const Vec3& x) { return glm::dot(x, x); };
  scene::Isosurface surface;
  surface.field = std::make_shared<const fields::LevelField>(
      std::vector{sampled(Vec3(-4), 0.5, 17, square), sampled(Vec3(-1.5), 0.25, 9, square)},
      fields::find_reconstruction("blend"));
  surface.value = 4;
  surface.corners = scene::corners_of(surface.field->bounds());
  surface.corners.colors.assign(8, Rgba(0.9, 0.4, 0.1, 0.4));
  scene.objects.push_back({"surface", surface, opaque});
  scene::PointObject ball;
  ball.set.positions = {Vec3(0.5, 0, 0)};
  ball.set.colors = {Rgba(0, 0.2, 1, 0.5)};
  ball.radius = 1;
  ball.profile = scene::PointObject::Profile::sphere;
  scene.objects.push_back({"ball", ball});
  return scene;
}

Image drawn(const scene::MethodRow& row, const scene::Scene& scene,
            const RawOptions& options = {}) {
  return testing::render(row, scene, options).image;
}

TEST(AgreementMarch, ComesCloserToTheExactCompositeWithShorterSteps) {
  for (const bool opaque : {false, true}) {
    const scene::Scene scene = balls(opaque);
    const Image exact = drawn(raytrace_method(), scene);
    const auto error = [&](const char* step) {
      return largest_difference(drawn(march_method(), scene, {{"step", step}}), exact);
    };
    EXPECT_GT(error("1"), 4 * error("16"));
    // Positions by bisection agree to some ulp, and so do the gradients that light them.
    EXPECT_LT(largest_difference(
                  drawn(march_method(), scene, {{"step", "16"}, {"refine", "bisection"}}), exact),
              1e-6);
  }
}

/// The plane x = z, seen along -z, in the colour of y from 0 (y = -1) to 1 (y = 1).
scene::Scene colored_plane() {
  scene::Scene scene = testing::orthographic_scene(16, 16);
  const auto levels = [](const auto& f) {
    return std::vector{sampled(Vec3(-4), 0.5, 17, f), sampled(Vec3(-0.5), 0.25, 9, f)};
  };
  const auto& blend = fields::find_reconstruction("blend");
  scene::Isosurface surface;
  surface.field = std::make_shared<const fields::LevelField>(
      levels([](const Vec3& x) { return x.x - x.z; }), blend);
  surface.coloring = {
      {std::make_shared<const fields::LevelField>(levels([](const Vec3& x) { return x.y; }), blend),
       Vec2(-1, 1)},
      &scene::find_colormap("four-color")};
  surface.corners = scene::corners_of(surface.field->bounds());
  surface.corners.colors.assign(8, Rgba(0, 0, 0, 1));
  scene.objects.push_back({"plane", surface});
  return scene;
}

TEST(UnitMarch, ASurfaceHasTheColourOfItsScalarWhereItIsCrossed) {
  const scene::Scene scene = colored_plane();
  for (const scene::MethodRow* row : {&raytrace_method(), &march_method()}) {
    const Image image = drawn(*row, scene);
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 16; ++x) {
        const Vec3 expected = scene::find_colormap("four-color")(1 - (y + 0.5) / 16);
        // Sums of floats near 1 of samples that floats hold.
        EXPECT_LT(glm::length(Vec3(image.at(x, y)) - expected), 1e-6) << x << ' ' << y;
      }
  }
}

TEST(UnitMarch, ASurfaceFadesByItsScalarWhereItIsCrossed) {
  scene::Scene scene = colored_plane();
  auto& surface = std::get<scene::Isosurface>(scene.objects.front().shape);
  surface.coloring->scalar.range = Vec2(-8, 8);
  surface.fading = {surface.coloring->scalar, Vec2(0.2, 1)};
  surface.fading->scalar.range = Vec2(-0.5, 1);
  for (const scene::MethodRow* row : {&raytrace_method(), &march_method()}) {
    const Image image = drawn(*row, scene);
    for (int y = 0; y < 16; ++y) {
      const double at = 1 - (y + 0.5) / 8;
      // A float picture of a share of samples in float, up to 4: 2.4e-7 / 1.5, and half an ulp
      // below 1.
      EXPECT_NEAR(image.at(5, y).a, at < -0.5 ? 0.2 : 0.2 + 0.8 * (at + 0.5) / 1.5, 2.2e-7) << y;
    }
  }
}

/// A ball of radius 1, and the plane z = -3 behind and z = 3 before it, seen along -z.
scene::Scene ball_between_planes() {
  scene::Scene scene = testing::orthographic_scene(40, 40);
  scene.camera.height = 4;
  scene.camera.eye = Vec3(0, 0, 10);
  scene.camera.target = Vec3(0);
  scene::Isosurface surface;
  surface.field = std::make_shared<const fields::LevelField>(
      std::vector{sampled(Vec3(-4), 0.5, 17, [](const Vec3& x) { return std::abs(x.z); })},
      fields::find_reconstruction("trilinear"));
  surface.value = 3;
  surface.corners = scene::corners_of(surface.field->bounds());
  surface.corners.colors.assign(8, Rgba(1, 0, 0, 0.5));
  scene.objects.push_back({"planes", surface});
  scene::PointObject ball;
  ball.set.positions = {Vec3(0)};
  ball.set.colors = {Rgba(0, 0, 1, 1)};
  ball.radius = 1;
  ball.profile = scene::PointObject::Profile::sphere;
  scene.objects.push_back({"ball", ball, true});
  return scene;
}

// Behind a crossing that hides all, a march finds none; behind one that fades, it goes on.
TEST(UnitMarch, AFadingSurfaceEndsRaysWhereItHidesAll) {
  scene::Scene scene = ball_between_planes();
  scene.objects.pop_back();
  auto& surface = std::get<scene::Isosurface>(scene.objects.front().shape);
  // From opaque at x = 0 to 0.5 at x = 4, the same on both planes.
  const auto x = std::make_shared<const fields::LevelField>(
      std::vector{sampled(Vec3(-4), 0.5, 17, [](const Vec3& p) { return p.x; })},
      fields::find_reconstruction("trilinear"));
  surface.fading = {{x, Vec2(0, 4)}, Vec2(1, 0.5)};
  const scene::Rendering rendering =
      march_method()
          .make(scene, Parameters("march", march_method().parameters, {}), {})
          ->render({});
  EXPECT_EQ(rendering.stats.fragments, 40u * 20u * 3u);  // one where x < 0, else both planes
  EXPECT_EQ(rendering.image.at(3, 3).a, 1);
}

TEST(UnitMarch, ADilatedSphereEndsRaysEvenWhereTheyMissIt) {
  const scene::Scene scene = ball_between_planes();
  const Image all = drawn(march_method(), scene);
  const Image filtered = drawn(march_method(), scene, {{"filter", "dilate:0.5"}});
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 40; ++x) {
      const double r = std::hypot((x + 0.5) / 10 - 2, (y + 0.5) / 10 - 2);
      if (std::abs(r - 1.5) < 1e-9 || std::abs(r - 1) < 1e-9) continue;
      // Half of red before: white behind; red and white; blue.
      const Rgba through(1, 0.25, 0.25, 0.75), once(1, 0.5, 0.5, 0.5), ball(0.5, 0, 0.5, 1);
      EXPECT_EQ(all.at(x, y), r < 1 ? ball : through) << x << ' ' << y;
      EXPECT_EQ(filtered.at(x, y), r < 1 ? ball : r < 1.5 ? once : through) << x << ' ' << y;
    }
}

TEST(UnitMarch, RefusesAFilterItDoesNotKnow) {
  for (const char* filter :
       {"dilate", "dilate:", "dilate:-1", "dilate:nan", "erode:1", "dilate:1 m"})
    EXPECT_THROW(drawn(march_method(), balls(false), {{"filter", filter}}), InputError) << filter;
}

TEST(AgreementMarch, ACameraInsideTheVolumeSeesWhatLiesBefore) {
  // Within the surface x² + y² + z² = 4 of both levels: each ray leaves it once.
  scene::Scene scene = balls(false);
  scene.objects.pop_back();
  scene.lighting = scene::Lighting::none;
  scene.camera.eye = Vec3(0.3, 0.1, 0.2);
  scene.camera.target = Vec3(1, 0.5, -2);
  for (const scene::MethodRow* row : {&raytrace_method(), &march_method()}) {
    const Image image = drawn(*row, scene);
    for (const Rgba& pixel : image.pixels) EXPECT_FLOAT_EQ(pixel.a, 0.4f);
  }
}

TEST(UnitMarch, RefusesAStepOutOfRange) {
  EXPECT_THROW(drawn(march_method(), balls(false), {{"step", "0"}}), InputError);
  EXPECT_THROW(drawn(march_method(), balls(false), {{"step", "65"}}), InputError);
}

}  // namespace
}  // namespace pellucid::groundtruth
