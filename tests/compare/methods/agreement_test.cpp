// SPDX-License-Identifier: GPL-3.0-or-later
// Independent paths to one picture: the ray tracer, and every method of the table by OpenGL.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "compare/methods/methods.h"
#include "core/options/names.h"
#include "scene/appearance/appearance.h"
#include "scene/files/scene_file.h"
#include "tests/support/pictures.h"
#include "tests/support/scenes.h"

namespace pellucid::compare {
namespace {

using namespace testing;

scene::Rendering draw_counted(const scene::Scene& scene, const scene::MethodRow& row) {
  return render(row, scene, {}, true);
}

scene::Rendering truth(const scene::Scene& scene) { return draw_counted(scene, methods().front()); }

/// Root mean square over a picture of what OpenGL's shift of corners by 1/256 pixel does to colours
/// that vary from corner to corner. Measured 3e-6 on the hardest scene here; ten times that.
constexpr double shift_of_colors = 3e-5;

/// Over the pixels in which both see as many layers.
struct Agreement {
  double rmse = 0, largest = 0;
  std::size_t other_coverage = 0;
};

Agreement agreement(const scene::Rendering& reference, const scene::Rendering& test) {
  Agreement result;
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < test.image.pixels.size(); ++i) {
    if (reference.layers.pixels[i] != test.layers.pixels[i]) {
      ++result.other_coverage;
      continue;
    }
    for (int c = 0; c < 3; ++c) {
      const double d =
          std::abs(double(reference.image.pixels[i][c]) - double(test.image.pixels[i][c]));
      result.largest = std::max(result.largest, d);
      sum += d * d;
      ++count;
    }
  }
  result.rmse = std::sqrt(sum / double(count));
  return result;
}

std::vector<std::string_view> names_of_methods(bool only_exact) {
  std::vector<std::string_view> names;
  for (const scene::MethodRow& row : methods())
    if (row.promises.exact || !only_exact) names.push_back(row.name);
  return names;
}

class PropertyMethodAgainstTruth : public ::testing::TestWithParam<std::string_view> {
 protected:
  const scene::MethodRow& row() const { return find_row("method", GetParam(), methods()); }
};
class PropertyExactMethod : public PropertyMethodAgainstTruth {};

TEST_P(PropertyMethodAgainstTruth, OneLayerIsTheTruth) {
  // One tilted, lit, many-coloured rectangle under perspective. Half precision has 5e-4 at 1,
  // so a method may not lose its fragment to it; float sums and an exp cost about 1e-6.
  scene::Scene scene;
  scene.width = 101;
  scene.height = 67;
  scene.lighting = scene::Lighting::headlight;
  scene.background = Vec3(0.9, 1, 0.8);
  geometry::TriangleMesh mesh = rectangle(-1, 1.2, -1.1, 1, 0, Rgba(0, 0, 0, 0.6f));
  for (std::size_t i = 0; i < 4; ++i) {
    mesh.positions[i].z = 0.3 * mesh.positions[i].x - 0.5 * mesh.positions[i].y;
    mesh.colors[i] =
        Rgba(0.1f + 0.2f * float(i), 0.9f - 0.2f * float(i), i % 2, 0.2f + 0.2f * float(i));
  }
  mesh.normals.clear();
  scene::ensure_normals(mesh);
  scene.objects = {{"", mesh}};
  const Agreement found = agreement(truth(scene), draw_counted(scene, row()));
  EXPECT_LE(found.largest, shift_of_colors);
  // The outline is some 250 pixels long, and OpenGL snaps it to 1/256 pixel.
  EXPECT_LE(found.other_coverage, 4u);
}

TEST_P(PropertyExactMethod, AgreesOnAHardScene) {
  scene::Scene scene;
  scene.width = scene.height = 200;
  scene.objects = {{"", random_triangles(400, 11)}, {"", sphere(3, Rgba(0.2, 0.5, 1, 0.3f))}};
  const Agreement found = agreement(truth(scene), draw_counted(scene, row()));
  EXPECT_LE(found.rmse, shift_of_colors);
  // Random triangles have some 400 · 100 pixels of outline; one in 256 is snapped past a centre.
  EXPECT_LE(found.other_coverage, 400u);
}

/// A ribbon that turns, and discs at depths of their own, side by side.
scene::Scene lines_and_points() {
  scene::Scene scene;
  scene.width = 121;
  scene.height = 97;
  scene.background = Vec3(0.9, 1, 0.8);
  scene::LineObject lines;
  lines.radius = 0.1;
  for (int i = 0; i < 9; ++i) {
    const double t = i / 8.0;
    lines.set.positions.emplace_back(-1.6 + 1.2 * t, 1.5 * std::sin(3 * t) - 0.7, t);
    lines.set.colors.emplace_back(t, 0.5, 1 - t, 0.3 + 0.5 * t);
  }
  lines.set.offsets = {0, 4, 9};
  scene::PointObject points;
  points.radius = 0.2;
  for (int i = 0; i < 4; ++i) {
    points.set.positions.emplace_back(0.6 + 0.6 * (i % 2), 0.7 * (i / 2) - 0.4, 0.3 * i - 0.5);
    points.set.colors.emplace_back(0.2 * i, 0.7, 0.4, 0.2 + 0.2 * i);
  }
  scene.objects = {{"lines", lines}, {"points", points}};
  return scene;
}

TEST_P(PropertyMethodAgainstTruth, OneLayerOfLinesAndPointsIsTheTruth) {
  for (const scene::Lighting lighting :
       {scene::Lighting::none, scene::Lighting::headlight, scene::Lighting::phong}) {
    scene::Scene scene = lines_and_points();
    scene.lighting = lighting;
    const scene::Rendering reference = truth(scene);
    EXPECT_EQ(reference.stats.max_layers, 1u);
    const Agreement found = agreement(reference, draw_counted(scene, row()));
    // √(1 - c²) turns the roundings of c, 1e-6 of snapped corners, into their root at a rim.
    EXPECT_LE(found.largest, lighting == scene::Lighting::none ? shift_of_colors : 1e-2);
    EXPECT_LE(found.rmse, shift_of_colors);
    // The outlines are some 600 pixels long, and OpenGL snaps them to 1/256 pixel.
    EXPECT_LE(found.other_coverage, 10u);
  }
}

/// Meshes, lines and points through each other, in turns, and opaque ones among them.
scene::Scene mixed_scene(bool with_opaque) {
  scene::Scene scene;
  scene.width = 120;
  scene.height = 90;
  std::mt19937 random(21);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto any = [&] { return Vec3(unit(random), unit(random), unit(random)); };
  for (int i = 0; i < 4; ++i) {
    scene::LineObject lines;
    lines.radius = 0.07;
    scene::PointObject points;
    points.radius = 0.15;
    for (int k = 0; k < 20; ++k) {
      lines.set.positions.push_back(any());
      lines.set.colors.emplace_back(0.5 + 0.5 * any(), 0.5 + 0.4 * unit(random));
      points.set.positions.push_back(any());
      points.set.colors.emplace_back(0.5 + 0.5 * any(), 0.5 + 0.4 * unit(random));
    }
    lines.set.offsets = {0, 7, 8, 20};
    const bool opaque = with_opaque && i == 2;
    scene.objects.push_back({"mesh", random_triangles(8, unsigned(i), 1), opaque});
    scene.objects.push_back({"lines", lines, opaque});
    scene.objects.push_back({"points", points, opaque});
  }
  return scene;
}

TEST_P(PropertyExactMethod, AgreesOnMixedShapes) {
  const scene::Scene scene = mixed_scene(false);
  const Agreement found = agreement(truth(scene), draw_counted(scene, row()));
  EXPECT_LE(found.rmse, shift_of_colors);
  EXPECT_LE(found.other_coverage, scene.width * scene.height / 100u);
}

TEST_P(PropertyExactMethod, WhatIsOpaqueHidesAsItDoesInTruth) {
  const scene::Scene scene = mixed_scene(true);
  const Agreement found = agreement(truth(scene), draw_counted(scene, row()));
  EXPECT_LE(found.rmse, shift_of_colors);
  EXPECT_LE(found.other_coverage, scene.width * scene.height / 100u);
}

// Every light beside every other one, in one scene, and objects that have the scene's.
TEST_P(PropertyExactMethod, ObjectsOfTheirOwnLightAreLitAsInTruth) {
  scene::Scene scene = mixed_scene(true);
  scene.lighting = scene::Lighting::headlight;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    scene::SceneObject& object = scene.objects[i];
    if (i % 4 < 3) object.lighting = scene::Lighting(i % 4);
    if (i % 3 > 0) continue;  // lines, points
    object.mesh().normals.clear();
    if (scene::lighting_of(scene, object) != scene::Lighting::none)
      scene::ensure_normals(object.mesh());
  }
  const Agreement found = agreement(truth(scene), draw_counted(scene, row()));
  EXPECT_LE(found.rmse, shift_of_colors);
  EXPECT_LE(found.other_coverage, scene.width * scene.height / 100u);
}

INSTANTIATE_TEST_SUITE_P(Methods, PropertyMethodAgainstTruth,
                         ::testing::ValuesIn(names_of_methods(false)), method_test_name);
INSTANTIATE_TEST_SUITE_P(Methods, PropertyExactMethod, ::testing::ValuesIn(names_of_methods(true)),
                         method_test_name);

TEST(SlowAgreement, LinkedListsEqualTheRayTracerOnTheAbcFlow) {
  const scene::Scene scene = scene::load_scene(PELLUCID_SOURCE_DIR "/scenes/abc.json");
  const scene::Rendering test = draw_counted(scene, find_row("method", "linked-list", methods()));
  const Agreement found = agreement(truth(scene), test);
  EXPECT_GE(test.stats.max_layers, 5u) << "the surface no longer folds over itself";
  EXPECT_LE(found.rmse, shift_of_colors);
  EXPECT_LE(found.other_coverage, test.image.pixels.size() / 1000);
}

}  // namespace
}  // namespace pellucid::compare
