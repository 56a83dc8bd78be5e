// SPDX-License-Identifier: GPL-3.0-or-later
// Lines and points keep the promises of every row, too.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "compare/methods/methods.h"
#include "tests/compare/methods/promise_scenes.h"

namespace pellucid::compare {
namespace {

using namespace testing;

/// What draws an object of one segment, or of one point.
struct Kind {
  const char* name;
  scene::SceneObject (*make)(const Vec3& a, const Vec3& b, double radius, const Rgba& color);
};

scene::SceneObject segment(const Vec3& a, const Vec3& b, double radius, const Rgba& color) {
  geometry::LineSet set;
  set.positions = {a, b};
  set.offsets = {0, 2};
  set.colors = {color, color};
  scene::SceneObject object;
  object.shape = scene::LineObject{std::move(set), radius, scene::LineObject::Profile::ribbon};
  return object;
}

scene::SceneObject point(const Vec3& a, const Vec3& b, double radius, const Rgba& color) {
  geometry::PointSet set;
  set.positions = {0.5 * (a + b)};
  set.colors = {color};
  scene::SceneObject object;
  object.shape = scene::PointObject{std::move(set), radius, scene::PointObject::Profile::disc};
  return object;
}

class PropertyShapes : public ::testing::TestWithParam<Kind> {
 protected:
  /// Over the whole picture, and beyond, at z.
  static scene::SceneObject cover(double z, const Rgba& color) {
    return GetParam().make({-50, 0, z}, {50, 0, z}, 50, color);
  }

  /// Front to back at equal distances between z = 1 and z = -1.
  static scene::Scene stack_of(int width, int height, const std::vector<Rgba>& layers) {
    scene::Scene scene = empty_scene(width, height);
    for (std::size_t i = 0; i < layers.size(); ++i)
      scene.objects.push_back(cover(1 - 2 * double(i) / double(layers.size()), layers[i]));
    return scene;
  }

  /// Many of any place, size, colour and opacity before a perspective camera.
  static scene::Scene cloud(int width, int height, int count, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(-1, 1);
    const auto any = [&] { return Vec3(unit(random), unit(random), unit(random)); };
    scene::Scene scene = empty_scene(width, height);
    scene.camera = {.eye = {0, 0, 3}, .target = {0, 0, 0}};
    for (int i = 0; i < count; ++i) {
      const Vec3 a = any(), b = any();
      scene.objects.push_back(GetParam().make(a, b, 0.2 + 0.1 * unit(random),
                                              Rgba(0.5 + 0.5 * any(), 0.5 + 0.5 * unit(random))));
    }
    return scene;
  }
};

TEST_P(PropertyShapes, OrderOfPrimitivesChangesNoMoreThanPromised) {
  const scene::Scene scene = cloud(37, 23, 60, 4), shuffled = compare::shuffled(scene, 5);
  for (const scene::MethodRow& row : methods())
    EXPECT_LE(largest_difference(render(row, scene).image, render(row, shuffled).image),
              row.promises.order_independent ? 0 : row.promises.order_spread)
        << row.name;
}

TEST_P(PropertyShapes, OneLayerIsTheTruthInAnyPictureSize) {
  const std::vector<Rgba> layer = {{0.9f, 0.2f, 0.4f, 0.3f}};
  for (const auto& [width, height] : {std::pair(1, 1), {1, 7}, {13, 1}, {31, 33}}) {
    const scene::Scene scene = stack_of(width, height, layer);
    for (const scene::MethodRow& row : methods())
      EXPECT_LE(largest_difference(render(row, scene).image, composite(layer, scene.background)),
                float_composite)
          << row.name << ' ' << width << " x " << height;
  }
}

TEST_P(PropertyShapes, ExactMethodsCompositeAStack) {
  const auto layers = random_layers(20, 1, 3);
  const scene::Scene scene = shuffled(stack_of(3, 2, layers), 2);
  for (const scene::MethodRow& row : methods())
    if (is_exact(row)) {
      EXPECT_LE(largest_difference(render(row, scene).image, composite(layers, scene.background)),
                float_composite)
          << row.name;
    }
}

TEST_P(PropertyShapes, OpacityZeroIsTheBackground) {
  scene::Scene scene = cloud(16, 16, 40, 9);
  for (scene::SceneObject& object : scene.objects)
    for (Rgba& color : object.vertices().colors) color.a = 0;
  for (const scene::MethodRow& row : methods())
    // A rounding of the background to float, and one of its share of 1.
    EXPECT_LE(largest_difference(render(row, scene).image, glm::dvec4(scene.background, 0)), 1e-7)
        << row.name;
}

// Red and green over a background of blue: no method may make blue of them, or white.
TEST_P(PropertyShapes, ColoursStayInTheirHull) {
  scene::Scene scene = cloud(19, 13, 80, 7);
  scene.background = {0, 0, 1};
  for (std::size_t i = 0; i < scene.objects.size(); ++i)
    for (Rgba& color : scene.objects[i].vertices().colors)
      color = {float(i % 2), float(1 - i % 2), 0, color.a};
  for (const scene::MethodRow& row : methods()) {
    if (!row.promises.convex_hull) continue;
    for (const Rgba& pixel : render(row, scene).image.pixels) {
      EXPECT_NEAR(pixel.r + pixel.g + pixel.b, 1, float_composite) << row.name;
      EXPECT_GE(std::min({pixel.r, pixel.g, pixel.b}), -1e-6f) << row.name;
    }
  }
}

// Rows that shift edges alike cover the same pixels. Between the others, ribbons and discs of some
// 10 pixels have some 50 · 60 pixels of outline, of which the shift, to either side, moves 2 / 256.
TEST_P(PropertyShapes, EveryFragmentIsSeenByEveryMethod) {
  const scene::Scene scene = cloud(24, 17, 50, 11);
  std::map<double, std::uint64_t> fragments;  // by edge_shift
  for (const scene::MethodRow& row : methods()) {
    const std::uint64_t seen = render(row, scene, {}, true).stats.fragments;
    EXPECT_EQ(fragments.try_emplace(row.promises.edge_shift, seen).first->second, seen) << row.name;
  }
  const double exact = double(fragments.at(0));
  EXPECT_GT(exact, 100);
  for (const auto& [edge_shift, seen] : fragments)
    EXPECT_NEAR(double(seen), exact, 2 * edge_shift * 50 * 60);
}

INSTANTIATE_TEST_SUITE_P(Of, PropertyShapes,
                         ::testing::Values(Kind{"lines", segment}, Kind{"points", point}),
                         [](const auto& kind) { return kind.param.name; });

}  // namespace
}  // namespace pellucid::compare
