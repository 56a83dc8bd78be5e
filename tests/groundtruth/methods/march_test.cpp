// SPDX-License-Identifier: GPL-3.0-or-later
// Marched isosurfaces: closed forms, what holds for any step, agreement with exact crossings.

#include "groundtruth/methods/march.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/error.h"
#include "groundtruth/levels/level_march.h"
#include "groundtruth/methods/raytrace.h"
#include "scene/appearance/colormap.h"
#include "tests/groundtruth/levels.h"
#include "tests/support/pictures.h"
#include "tests/support/scenes.h"

namespace pellucid::groundtruth {
namespace {

using testing::largest_difference;

std::vector<double> marched(const fields::LevelField& field, double value, const WorldRay& ray,
                            const MarchOptions& options) {
  std::vector<double> at;
  LevelMarch(field, value, options).visit_crossings(ray, [&](double t) {
    at.push_back(t);
    return true;
  });
  return at;
}

/// Rays through random places of the nested field's cube.
std::vector<WorldRay> random_rays(std::size_t count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0.7, 7.3);
  const auto any = [&] { return Vec3(uniform(random), uniform(random), uniform(random)); };
  std::vector<WorldRay> rays;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 a = any(), b = any();
    rays.push_back({a, glm::normalize(b - a)});
  }
  return rays;
}

class PropertyMarch : public ::testing::TestWithParam<fields::ReconstructionRow> {};
INSTANTIATE_TEST_SUITE_P(All, PropertyMarch, ::testing::ValuesIn(fields::reconstructions),
                         [](const auto& row) { return std::string(row.param.name); });

TEST_P(PropertyMarch, HalvingTheStepLosesNoCrossing) {
  // The samples of a step are among those of half of it, and of samples with fewer others between
  // them no fewer pairs differ in sign.
  const fields::LevelField field = nested(wavy, GetParam());
  std::size_t coarsest = 0, finest = 0;
  for (const WorldRay& ray : random_rays(100)) {
    std::size_t before = 0;
    for (const double steps : {0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0}) {
      const std::size_t found = marched(field, 0.05, ray, {.steps_per_cell = steps}).size();
      EXPECT_GE(found, before);
      before = found;
      if (steps == 0.25) coarsest += found;
    }
    finest += before;
  }
  EXPECT_LT(coarsest, finest);  // long steps lose some
}

TEST_P(PropertyMarch, EmptySpaceSkippedChangesNothing) {
  const fields::LevelField field(
      {sampled(Vec3(0.5), 1, 24, wavy), sampled(Vec3(2.25), 0.5, 20, wavy)}, GetParam());
  std::size_t found = 0;
  for (const WorldRay& away : random_rays(200)) {
    const WorldRay ray{away.at(30), -away.direction};  // through empty blocks to the surface
    const auto all = marched(field, 0.9, ray, {.skip_empty = false});
    EXPECT_EQ(marched(field, 0.9, ray, {.skip_empty = true}), all);
    found += all.size();
  }
  EXPECT_GT(found, 20u);
}

TEST_P(PropertyMarch, BisectionFindsTheExactCrossings) {
  const fields::LevelField field = nested(wavy, GetParam());
  std::size_t found = 0;
  for (const WorldRay& ray : random_rays(60)) {
    const auto exact = exact_crossings(field, 0.05, ray);
    for (const double t : marched(field, 0.05, ray,
                                  {.steps_per_cell = 16, .refinement = HitRefinement::bisection})) {
      ++found;
      // As for exact crossings: 1e-9 of the finest cell.
      EXPECT_TRUE(std::ranges::any_of(exact, [&](double other) {
        return std::abs(other - t) < 0.5e-9;
      })) << t;
    }
  }
  EXPECT_GT(found, 60u);
}

TEST(UnitMarch, ASphereIsEnteredAndLeft) {
  const auto distance = [](const Vec3& x) { return glm::length(x - 4.0); };
  const fields::LevelField field({sampled(Vec3(0), 0.125, 65, distance)},
                                 fields::find_reconstruction("blend"));
  // Along the axis the samples' lines are those of the march: linear placement is exact up to
  // float, and so is bisection.
  for (const HitRefinement refinement : {HitRefinement::linear, HitRefinement::bisection}) {
    const auto at = marched(field, 2, {Vec3(-2, 4, 4), Vec3(1, 0, 0)}, {.refinement = refinement});
    ASSERT_EQ(at.size(), 2u);
    // Samples near 2 in float are off by 1.2e-7, and the slope is 1.
    EXPECT_NEAR(at[0], 4, 2.4e-7);
    EXPECT_NEAR(at[1], 8, 2.4e-7);
  }
}

// The field is 4 - x, above 2 from the volume's face to x = 2 and below beyond; then the same the
// other way round, which the ray enters between two samples.
TEST(UnitMarch, TheReportsHitIsTheFirstSampleInside) {
  const auto falling = [](const Vec3& x) { return 4 - x.x; };
  const auto rising = [](const Vec3& x) { return x.x; };
  const MarchOptions as_reported{.steps_per_cell = 2, .refinement = HitRefinement::sample};
  const WorldRay ray{Vec3(-2, 4, 4), Vec3(1, 0, 0)};
  const fields::ReconstructionRow& trilinear = fields::find_reconstruction("trilinear");
  const fields::LevelField falls({sampled(Vec3(0), 1, 9, falling)}, trilinear),
      rises({sampled(Vec3(0), 1, 9, rising)}, trilinear);
  const auto inside_at_first = marched(falls, 2, ray, as_reported);
  ASSERT_EQ(inside_at_first.size(), 1u);  // the way out does not count
  EXPECT_NEAR(inside_at_first[0], 2, 1e-12);
  const auto entered = marched(rises, 2.1, ray, as_reported);
  ASSERT_EQ(entered.size(), 1u);
  EXPECT_NEAR(entered[0], 4.5, 1e-12);  // samples at x = 2 and 2.5
}

TEST(UnitMarch, LinearPlacementConvergesAtOrderTwo) {
  // x y z is its own reconstruction, without a kink within the cell that the rays stay in, and
  // grows along rays of positive direction: the line through two samples a step h apart errs by
  // |f''| h² / 8 |f'| at most.
  const auto product = [](const Vec3& x) { return x.x * x.y * x.z; };
  const fields::LevelField field({sampled(Vec3(0), 8, 3, product)},
                                 fields::find_reconstruction("trilinear"));
  double before = 0;
  for (const double steps : {4.0, 16.0, 64.0}) {
    double worst = 0;
    for (const WorldRay& any : random_rays(60)) {
      const WorldRay ray{Vec3(0.5), glm::abs(any.direction) + 0.2};
      const auto exact = exact_crossings(field, 30, ray);
      const auto at = marched(field, 30, ray, {.steps_per_cell = steps});
      ASSERT_EQ(exact.size(), 1u);
      ASSERT_EQ(at.size(), 1u);
      worst = std::max(worst, std::abs(at[0] - exact[0]));
    }
    if (before > 0) {
      EXPECT_LT(worst, before / 12);  // 16, where h is short enough for h³ not to count
    }
    before = worst;
  }
  EXPECT_GT(before, 0);
}

TEST(UnitMarch, CrossingsCloserThanAStepAreLost) {
  // |x - 4.5| < 0.25 lies between the samples of steps of a cell, and is found by shorter ones.
  const auto slab = [](const Vec3& x) { return std::abs(x.x - 4.5); };
  const fields::LevelField field({sampled(Vec3(0), 0.5, 17, slab)},
                                 fields::find_reconstruction("trilinear"));
  const WorldRay ray{Vec3(-1, 3.2, 3.3), Vec3(1, 0, 0)};
  EXPECT_TRUE(marched(field, 0.25, ray, {.steps_per_cell = 0.5}).empty());
  EXPECT_EQ(marched(field, 0.25, ray, {.steps_per_cell = 4}).size(), 2u);
}

TEST(UnitMarch, StartsInsideTheVolumeAndEndsWhenTold) {
  const fields::LevelField field =
      nested([](const Vec3& x) { return x.x; }, fields::find_reconstruction("trilinear"));
  EXPECT_EQ(marched(field, 3, {Vec3(5, 4, 4), Vec3(1, 0, 0)}, {}).size(), 0u);
  EXPECT_EQ(marched(field, 3, {Vec3(2.5, 4, 4), Vec3(1, 0, 0)}, {}).size(), 1u);
  EXPECT_EQ(marched(field, 3, {Vec3(-1, 9, 4), Vec3(1, 0, 0)}, {}).size(), 0u);  // passes by
  const fields::LevelField waves(
      {sampled(Vec3(0), 0.125, 65, [](const Vec3& x) { return sin(4 * x.x); })},
      fields::find_reconstruction("trilinear"));
  int seen = 0;
  LevelMarch(waves, 0.5, {}).visit_crossings({Vec3(-1, 4, 4), Vec3(1, 0, 0)}, [&](double) {
    return ++seen < 3;
  });
  EXPECT_EQ(seen, 3);
}

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
