// SPDX-License-Identifier: GPL-3.0-or-later
// Isosurfaces by two independent paths: the ray tracer's cells, and the pieces that OpenGL casts
// rays at. No outline is rasterized, so that every pixel has the same crossings.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "compare/methods/methods.h"
#include "core/options/names.h"
#include "scene/appearance/colormap.h"
#include "scene/files/scene_file.h"
#include "tests/support/levels.h"
#include "tests/support/part_scenes.h"
#include "tests/support/pictures.h"
#include "tests/support/scenes.h"

namespace pellucid::compare {
namespace {

using namespace testing;

double wavy(const Vec3& x) {
  return std::sin(4 * x.x) * std::cos(3 * x.y) + 0.5 * std::sin(5 * x.z);
}
double slope(const Vec3& x) { return std::exp(2 * x.x + x.y); }

/// Levels over [-1, 1]³ `scale` times as large, in any order of widths.
enum class Arrangement { nested, across };

template <class Function>
std::shared_ptr<const fields::LevelField> field_of(const Function& f, Arrangement arrangement,
                                                   const fields::ReconstructionRow& row,
                                                   double scale = 1) {
  const auto scaled = [&](const Vec3& x) { return f(x / scale); };
  const auto level = [&](const Vec3& origin, double width, int n) {
    return sampled(scale * origin, scale * width, n, scaled);
  };
  std::vector<fields::ScalarLevel> levels = {level(Vec3(-0.875), 0.25, 8),
                                             level(Vec3(-0.4375), 0.125, 8)};
  if (arrangement == Arrangement::across) levels.push_back(level(Vec3(-0.1, 0.2, 0.3), 0.09, 9));
  return std::make_shared<fields::LevelField>(std::move(levels), row);
}

scene::Isosurface surface_of(Arrangement arrangement, const fields::ReconstructionRow& row,
                             double scale = 1) {
  scene::Isosurface surface;
  surface.field = field_of(wavy, arrangement, row, scale);
  surface.value = 0.1;
  surface.corners = scene::corners_of(surface.field->bounds());
  surface.corners.colors.assign(8, Rgba(0.8, 0.4, 0.2, 0.35));
  return surface;
}

scene::Scene scene_of(scene::Isosurface surface) {
  scene::Scene scene = empty_scene(61, 47);
  scene.camera = {.eye = {0.9, 1.3, 3.2}, .target = {0, 0, 0}};
  scene.objects.push_back({"waves", std::move(surface)});
  return scene;
}

scene::Rendering draw(std::string_view method, const scene::Scene& scene) {
  return render(find_row("method", method, methods()), scene, {}, true);
}

std::size_t pixels_off(const Image& a, const Image& b, double by) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    for (int c = 0; c < 4; ++c)
      if (std::abs(double(a.pixels[i][c]) - double(b.pixels[i][c])) > by) {
        ++count;
        break;
      }
  return count;
}

/// Lists composite exactly: no crossing is missing or doubled, and each has its depth, colour and
/// opacity. `on_jumps` pixels may show a crossing on a face where the field jumps, whose light and
/// scalars are those of the side that rounding puts the ray tracer on.
void expect_agreement(const scene::Scene& scene, const std::string& what,
                      double by = float_composite, std::size_t on_jumps = 0) {
  const scene::Rendering reference = draw("raytrace", scene), test = draw("linked-list", scene);
  EXPECT_GT(reference.stats.fragments, 200u) << what;
  EXPECT_EQ(reference.layers.pixels, test.layers.pixels) << what;
  EXPECT_LE(pixels_off(reference.image, test.image, by), on_jumps) << what;
}

/// Of a reconstruction that jumps where the resolution changes: 1 % of the pixels.
std::size_t on_jumps(const fields::ReconstructionRow& row) { return row.continuous ? 0 : 29; }

/// Pixels in which they do not have as many crossings.
std::size_t counts_off(const scene::Scene& scene) {
  const scene::Rendering reference = draw("raytrace", scene), test = draw("linked-list", scene);
  std::size_t count = 0;
  for (std::size_t i = 0; i < reference.layers.pixels.size(); ++i)
    count += reference.layers.pixels[i] != test.layers.pixels[i];
  return count;
}

class PropertyIsosurfaceAgreement : public ::testing::TestWithParam<fields::ReconstructionRow> {};
INSTANTIATE_TEST_SUITE_P(All, PropertyIsosurfaceAgreement,
                         ::testing::ValuesIn(fields::reconstructions),
                         [](const auto& row) { return std::string(row.param.name); });

TEST_P(PropertyIsosurfaceAgreement, OfEveryCameraAndLight) {
  for (const Arrangement arrangement : {Arrangement::nested, Arrangement::across})
    for (const auto lighting :
         {scene::Lighting::none, scene::Lighting::headlight, scene::Lighting::phong})
      for (const bool parallel : {false, true}) {
        scene::Scene scene = scene_of(surface_of(arrangement, GetParam()));
        scene.lighting = lighting;
        if (parallel) {
          scene.camera.projection = scene::Projection::orthographic;
          scene.camera.height = 2.3;
        }
        expect_agreement(scene, std::to_string(int(arrangement)) + (parallel ? " parallel" : ""),
                         float_composite, on_jumps(GetParam()));
      }
}

TEST_P(PropertyIsosurfaceAgreement, OfEyesWithinTheField) {
  scene::Scene scene = scene_of(surface_of(Arrangement::across, GetParam()));
  for (const Vec3 eye : {Vec3(0.01, 0.02, 0.03), Vec3(0.5, 0, 0), Vec3(-0.4375, 0.0625, 0.9)}) {
    scene.camera.eye = eye;
    scene.camera.target = eye + Vec3(0.2, -0.3, -1);
    expect_agreement(scene, "eye " + std::to_string(eye.x));
  }
}

/// Rays through samples, faces and edges of cells of both levels, along the axes.
TEST_P(PropertyIsosurfaceAgreement, OfRaysOnTheFacesOfCells) {
  scene::Scene scene = scene_of(surface_of(Arrangement::nested, GetParam()));
  scene.width = scene.height = 33;
  scene.camera.projection = scene::Projection::orthographic;
  scene.camera.height = 33. / 16;  // pixels lie 1/16 apart, from -1 to 1
  for (const Vec3 from : {Vec3(0, 0, 3), Vec3(0, 0, -3), Vec3(3, 0, 0)}) {
    scene.camera.eye = from;
    expect_agreement(scene, "from " + std::to_string(from.x));
  }
}

TEST_P(PropertyIsosurfaceAgreement, OfSizesAndDistances) {
  for (const double scale : {1e-30, 1e-6, 1e6, 1e30}) {
    scene::Scene scene = scene_of(surface_of(Arrangement::nested, GetParam(), scale));
    scene.camera.eye *= scale;
    expect_agreement(scene, "scale " + std::to_string(scale));
  }
  // Two hundred thousand times its size away: an ulp of the eye is 1e-5 of a pixel.
  scene::Scene scene = scene_of(surface_of(Arrangement::nested, GetParam()));
  scene.camera.eye *= 1e5;
  scene.camera.fov = 4e-4;
  expect_agreement(scene, "far away");
}

/// Planes of samples that have the value, on faces between pieces; where levels have widths and
/// places that are no sums of a few powers of two.
TEST_P(PropertyIsosurfaceAgreement, OfPlanesOfSamplesThatHaveTheValue) {
  const auto steps = [](const Vec3& x) { return std::round(10 * (x.x + 0.88)); };  // 0 … 8
  for (const double beyond : {-1., 20.}) {
    scene::Isosurface surface = surface_of(Arrangement::nested, GetParam());
    surface.field = std::make_shared<fields::LevelField>(
        std::vector<fields::ScalarLevel>{
            sampled(Vec3(-1.33, -0.85, -0.85), 0.2, 9, [&](const Vec3&) { return beyond; }),
            sampled(Vec3(-0.88, -0.4, -0.4), 0.1, 9, steps)},
        GetParam());
    surface.corners = scene::corners_of(surface.field->bounds());
    surface.corners.colors.assign(8, Rgba(0.8, 0.4, 0.2, 0.35));
    // Where the value is only touched, both differ: see docs/isosurface.md.
    for (const double value : beyond < 0 ? std::vector{1., 4.} : std::vector{4., 7.}) {
      surface.value = value;
      scene::Scene scene = scene_of(surface);
      for (const Vec3 from : {Vec3(3, 0, 0), Vec3(-3, 0, 0), Vec3(0.9, 1.3, 3.2)}) {
        scene.camera.eye = from;
        EXPECT_LE(counts_off(scene), on_jumps(GetParam()))
            << beyond << ' ' << value << ' ' << from.x;
      }
    }
  }
}

/// Noise on a level that covers samples of a coarser one: hats of neither reach what lies beyond.
TEST_P(PropertyIsosurfaceAgreement, OfNoiseOverCoveredSamples) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  const auto noise = [&](const Vec3&) { return normal(random); };
  scene::Isosurface surface = surface_of(Arrangement::nested, GetParam());
  surface.field = std::make_shared<fields::LevelField>(
      std::vector<fields::ScalarLevel>{sampled(Vec3(-0.7), 0.2, 8, noise),
                                       sampled(Vec3(0.05, 0.1, -0.6), 0.11, 6, noise)},
      GetParam());
  surface.corners = scene::corners_of(surface.field->bounds());
  surface.corners.colors.assign(8, Rgba(0.8, 0.4, 0.2, 0.35));
  scene::Scene scene = scene_of(surface);
  scene.camera.projection = scene::Projection::orthographic;
  scene.camera.height = 1.8;
  for (const Vec3 from : {Vec3(3, 3, 3), Vec3(0.1, 3, 0.2), Vec3(2.7, 3.1, -3.3)}) {
    scene.camera.eye = from;
    EXPECT_LE(counts_off(scene), on_jumps(GetParam())) << from.x;
  }
}

/// Levels that abut, or have faces in common, at planes that are the same but for rounding: 0.1 + 6
/// · 0.2 is not 0.5 + 8 · 0.1.
TEST_P(PropertyIsosurfaceAgreement, OfLevelsWhoseFacesLieOneUlpApart) {
  std::mt19937 random(9);
  std::normal_distribution<double> normal;
  const auto noise = [&](const Vec3&) { return normal(random); };
  const auto levels = [&](bool abut) {
    std::vector<fields::ScalarLevel> both;
    both.push_back(abut ? sampled(Vec3(0.013, -0.8, -0.8), 0.2, 5, noise)
                        : sampled(Vec3(0.1), 0.2, 9, noise));
    both.push_back(abut ? sampled(Vec3(0.025, -0.787, -1e-16), 0.05, 9, noise)
                        : sampled(Vec3(0.1, 0.3, 0.5), 0.1, 9, noise));
    return both;
  };
  for (const bool abut : {true, false}) {
    scene::Isosurface surface = surface_of(Arrangement::nested, GetParam());
    surface.field = std::make_shared<fields::LevelField>(levels(abut), GetParam());
    surface.corners = scene::corners_of(surface.field->bounds());
    surface.corners.colors.assign(8, Rgba(0.8, 0.4, 0.2, 0.35));
    scene::Scene scene = scene_of(surface);
    scene.lighting = scene::Lighting::headlight;
    scene.camera.target = surface.field->bounds().center();
    scene.camera.eye = scene.camera.target + Vec3(1.7, 2.1, 3.2);
    EXPECT_LE(counts_off(scene), on_jumps(GetParam())) << abut;
  }
}

scene::Isosurface::OtherScalar by_slope(const Arrangement arrangement,
                                        const fields::ReconstructionRow& row, const Vec2& range,
                                        scene::Scale scale) {
  return {field_of(slope, arrangement, row), range, scale};
}

TEST_P(PropertyIsosurfaceAgreement, OfColoursAndOpacitiesByScalars) {
  const auto custom = std::make_shared<const scene::Colormap>(std::vector<scene::ColorStop>{
      {2, Vec3(1, 0, 0)}, {2.1, Vec3(0, 0, 1)}, {5, Vec3(0.5, 1, 0)}});
  for (const scene::Scale scale : {scene::Scale::linear, scene::Scale::logarithmic})
    for (const Vec2 range : {Vec2(0.2, 6), Vec2(6, 0.2), Vec2(1, 1)})
      for (const bool own_map : {false, true}) {
        scene::Isosurface surface = surface_of(Arrangement::across, GetParam());
        const auto scalar = by_slope(Arrangement::across, GetParam(), range, scale);
        surface.coloring = {scalar, &scene::find_colormap("turbo"), own_map ? custom : nullptr};
        surface.fading = {scalar, Vec2(0.1, 0.8)};
        const std::string what = std::to_string(int(scale)) + ", range " + std::to_string(range.x);
        // The logarithm is taken in float: of a range of e^3.4, 1e-7 of the map, whose colours
        // change by at most 4 (turbo) or, within a thirtieth of its length, 30.
        expect_agreement(scene_of(surface), what, 2 * float_composite, on_jumps(GetParam()));
      }
}

/// Densities of a plasma, and ranges of more decades than a float has.
TEST(PropertyIsosurfaceScenes, ColoursAndOpacitiesByHugeScalarsAgree) {
  struct Case {
    double low, high;
    scene::Scale scale;
  };
  using enum scene::Scale;
  for (const Case& c : {Case{2e17, 1e18, linear}, Case{1e30, 2e30, linear},
                        Case{1e-30, 1e30, logarithmic}, Case{1e30, 1e-30, logarithmic}}) {
    const auto scalar = [&](const Vec3& x) {
      const double at = 0.5 + 0.4 * x.x;
      return c.scale == scene::Scale::linear ? c.low + (c.high - c.low) * at
                                             : c.low * std::pow(c.high / c.low, at);
    };
    const fields::ReconstructionRow& row = fields::find_reconstruction("blend");
    scene::Isosurface surface = surface_of(Arrangement::nested, row);
    const scene::Isosurface::OtherScalar by{field_of(scalar, Arrangement::nested, row),
                                            Vec2(c.low, c.high), c.scale};
    surface.coloring = {by, &scene::find_colormap("viridis"), nullptr};
    surface.fading = {by, Vec2(0.1, 0.8)};
    expect_agreement(scene_of(surface), "from " + std::to_string(c.low), 2 * float_composite);
  }
}

TEST(PropertyIsosurfaceScenes, HolesOpaqueOnesAndOtherShapesAgree) {
  const fields::ReconstructionRow& row = fields::find_reconstruction("blend");
  scene::Isosurface with_hole = surface_of(Arrangement::nested, row);
  with_hole.hole = scene::Isosurface::Ball{{0.1, 0.2, 0.3}, 0.45};
  scene::Scene scene = scene_of(with_hole);
  expect_agreement(scene, "hole");
  scene::Isosurface second = surface_of(Arrangement::across, row);
  second.value = -0.4;
  scene.objects.push_back({"second", second});
  expect_agreement(scene, "two");
  scene.objects.back().opaque = true;
  expect_agreement(scene, "an opaque one");
  scene.objects.push_back(part_scenes::spheres(3));
  expect_agreement(scene, "and spheres");
}

/// One sheet in front of the background: whatever a method approximates, nothing is left of it.
TEST(PropertyIsosurfaceScenes, OneLayerIsTheTruthOfEveryMethod) {
  scene::Isosurface plane;
  plane.field = field_of([](const Vec3& x) { return 0.3 * x.x + x.z - 0.1 * x.y; },
                         Arrangement::nested, fields::find_reconstruction("trilinear"));
  plane.corners = scene::corners_of(plane.field->bounds());
  plane.corners.colors.assign(8, Rgba(0.8, 0.4, 0.2, 0.35));
  scene::Scene scene = scene_of(plane);
  scene.lighting = scene::Lighting::headlight;
  const scene::Rendering reference = draw("raytrace", scene);
  EXPECT_EQ(reference.stats.max_layers, 1u);
  for (const scene::MethodRow& row : methods()) {
    if (row.promises.random || row.name == "march") continue;
    // An exp and float sums cost about 1e-6.
    EXPECT_LE(largest_difference(draw(row.name, scene).image, reference.image), 3e-5) << row.name;
  }
}

/// Behind important spheres: what is chosen of them is as if it were not there.
TEST(PropertyIsosurfaceScenes, KeepTheirOpacityWhereElementsLoseTheirs) {
  scene::Scene scene = scene_of(surface_of(Arrangement::nested, fields::reconstructions[2]));
  scene::SceneObject spheres = part_scenes::spheres(3);
  const std::size_t count = spheres.vertices().positions.size();
  for (std::size_t i = 0; i < count; ++i)
    spheres.vertices().importance.push_back(i % 2 == 0 ? 0.9f : 0.1f);
  scene.objects.push_back(spheres);
  scene::Scene alone = scene;
  alone.objects.erase(alone.objects.begin());
  for (const char* name : {"fourier-opacity", "decoupled-lists"}) {
    const scene::MethodRow& row = find_row("method", name, methods());
    const auto opacities = [&](const scene::Scene& drawn) {
      return row.make(drawn, Parameters(row.name, row.parameters, {}), {})
          ->optimized_opacities()
          .value();
    };
    if (name == std::string_view("decoupled-lists")) {  // a series hangs on the range of depths
      EXPECT_EQ(opacities(scene).of_points, opacities(alone).of_points);
    }
    EXPECT_GT(draw(name, scene).stats.fragments, draw(name, alone).stats.fragments) << name;
  }
}

TEST(UnitIsosurfaceScenes, WhatOpenGlDoesNotDrawIsRefused) {
  scene::Isosurface surface = surface_of(Arrangement::nested, fields::find_reconstruction("blend"));
  surface.hole = scene::Isosurface::Body{};
  try {
    draw("linked-list", scene_of(surface));
    FAIL() << "a hole of a mesh is drawn";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("a hole of a mesh"), std::string::npos);
  }
}

}  // namespace
}  // namespace pellucid::compare
