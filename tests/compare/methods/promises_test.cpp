// SPDX-License-Identifier: GPL-3.0-or-later
// Every row of the method table keeps what it promises, whatever the scene.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>

#include "tests/oit/test_scenes.h"

namespace pellucid::oit::test {
namespace {

/// Slanted, intersecting triangles under a perspective camera; some reach behind the eye.
scene::Scene triangle_cloud(int width, int height, int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  scene::Scene scene = empty_scene(width, height);
  scene.camera = {.eye = {0, 0, 3}, .target = {0, 0, 0}};
  for (int i = 0; i < count; ++i) {
    scene::SceneObject object;
    for (int corner = 0; corner < 3; ++corner) {
      object.mesh().positions.emplace_back(1.5 * unit(random), 1.5 * unit(random),
                                           4 * unit(random));
      object.mesh().normals.push_back(glm::normalize(Vec3(unit(random), unit(random), 1.5)));
      object.mesh().colors.emplace_back(0.5 + 0.5 * unit(random), 0.5 + 0.5 * unit(random),
                                        0.5 + 0.5 * unit(random), 0.5 + 0.5 * unit(random));
    }
    object.mesh().triangles = {{0, 1, 2}};
    scene.objects.push_back(std::move(object));
  }
  return scene;
}

bool finite(const Image& image) {
  for (const Rgba& pixel : image.pixels)
    for (int c = 0; c < 4; ++c)
      if (!std::isfinite(pixel[c])) return false;
  return true;
}

TEST(PropertyMethods, OrderOfPrimitivesChangesNoMoreThanPromised) {
  const scene::Scene scene = triangle_cloud(37, 23, 60, 4);
  scene::Scene shuffled = scene;
  std::mt19937 random(5);
  std::shuffle(shuffled.objects.begin(), shuffled.objects.end(), random);
  for (const scene::MethodRow& row : oit_methods()) {
    const double difference = max_difference(render(row, scene).image, render(row, shuffled).image);
    EXPECT_LE(difference, row.promises.order_independent ? 0 : row.promises.order_spread)
        << row.name;
  }
}

TEST(PropertyMethods, ExactMethodsAgreeWithEachOther) {
  const scene::Scene scene = triangle_cloud(41, 31, 80, 6);
  const Image reference = render(method("linked-list"), scene).image;
  for (const scene::MethodRow& row : oit_methods()) {
    if (!row.promises.exact) continue;
    EXPECT_LE(max_difference(render(row, scene).image, reference), 1e-5) << row.name;
  }
}

TEST(PropertyMethods, ColoursStayInTheirHull) {
  // Red and green layers over a background of blue 0.9: no method may make blue of them, or white.
  std::vector<Rgba> layers = random_layers(30, 1.0f, 7);
  for (Rgba& layer : layers) layer = {layer.r > 0.5f, layer.r <= 0.5f, 0, layer.a};
  scene::Scene scene = stack(3, 3, layers);
  scene.background = {0, 0, 0.9};
  for (const scene::MethodRow& row : oit_methods()) {
    if (!row.promises.convex_hull) continue;
    const Image image = render(row, scene).image;
    for (const Rgba& pixel : image.pixels) {
      // Barycentric coordinates of red, green and the background.
      EXPECT_NEAR(pixel.r + pixel.g + pixel.b / 0.9f, 1, 1e-5) << row.name;
      EXPECT_GE(std::min({pixel.r, pixel.g, pixel.b}), -1e-6f) << row.name;
    }
  }
}

/// The defaults of a row, and budgets that its layers exceed, if it has any.
std::vector<RawOptions> with_small_budgets(const scene::MethodRow& row) {
  std::vector<RawOptions> options{{}};
  for (const ParameterSpec& spec : row.parameters)
    if (spec.name == "peels" || spec.name == "layers" || spec.name == "subset")
      options.push_back({{std::string(spec.name), "3"}});
  return options;
}

// A layer that the picture does not depend on was dropped: then the stats say so.
TEST(PropertyMethods, NothingIsDroppedInSilence) {
  constexpr int n = 9;
  const std::vector<Rgba> layers(n, Rgba(0.2f, 0.4f, 0.1f, 0.2f));
  const scene::Scene scene = stack(8, 8, layers);
  for (const scene::MethodRow& row : oit_methods())
    for (const RawOptions& options : with_small_budgets(row)) {
      SCOPED_TRACE(std::string(row.name) + (options.empty() ? "" : ":" + options.begin()->first));
      const scene::Rendering all = render(row, scene, options, true);
      EXPECT_EQ(all.stats.fragments, 64u * n);
      EXPECT_LE(all.stats.stored + all.stats.dropped, all.stats.fragments);
      EXPECT_EQ(all.stats.dropped > 0, all.stats.truncated > 0);
      std::uint64_t without_effect = 0;
      for (const int changed : {0, 4, 8}) {
        std::vector<Rgba> others = layers;
        others[std::size_t(changed)].r = 0.9f;
        const Image image = render(row, stack(8, 8, others), options).image;
        without_effect += max_difference(image, all.image) == 0;
      }
      EXPECT_EQ(without_effect > 0, all.stats.dropped > 0) << without_effect << " of 3";
    }
}

TEST(PropertyMethods, FixedMemoryDependsOnThePictureAlone) {
  for (const scene::MethodRow& row : oit_methods()) {
    if (!row.promises.fixed_memory) continue;
    const auto few = render(row, triangle_cloud(20, 10, 3, 8)).stats.total_bytes();
    const auto many = render(row, triangle_cloud(20, 10, 300, 8)).stats.total_bytes();
    EXPECT_EQ(few, many) << row.name;
    EXPECT_GT(few, 0u) << row.name;
  }
}

TEST(PropertyMethods, NothingVisibleIsTheBackground) {
  scene::Scene scene = empty_scene(4, 3);
  scene.objects = {sheet(0, {1, 1, 1, 1})};
  for (Vec3& x : scene.objects[0].mesh().positions) x.x += 100;
  const glm::dvec4 expected(scene.background, 0);
  for (const scene::MethodRow& row : oit_methods())
    EXPECT_LE(max_difference(render(row, scene).image, expected), 1e-7) << row.name;
}

TEST(PropertyMethods, OpacityZeroIsTheBackground) {
  scene::Scene scene = triangle_cloud(16, 16, 40, 9);
  for (scene::SceneObject& object : scene.objects)
    for (Rgba& color : object.mesh().colors) color.a = 0;
  const glm::dvec4 expected(scene.background, 0);
  for (const scene::MethodRow& row : oit_methods())
    EXPECT_LE(max_difference(render(row, scene).image, expected), 1e-7) << row.name;
}

TEST(PropertyMethods, PicturesAreFinite) {
  for (const float alpha : {1e-8f, 0.9999f, 1 - 1e-7f, 1.0f}) {
    scene::Scene scene = triangle_cloud(16, 9, 200, 10);
    for (scene::SceneObject& object : scene.objects)
      for (Rgba& color : object.mesh().colors) color.a = alpha;
    for (const scene::MethodRow& row : oit_methods())
      EXPECT_TRUE(finite(render(row, scene).image)) << row.name << " alpha " << alpha;
  }
}

TEST(PropertyMethods, EveryChoiceOfEveryParameterDraws) {
  const scene::Scene scene = triangle_cloud(16, 9, 100, 13);
  const std::vector<Rgba> one_layer = {{0.2f, 0.4f, 0.8f, 0.5f}};
  const scene::Scene single = stack(4, 4, one_layer);
  for (const scene::MethodRow& row : oit_methods())
    for (const ParameterSpec& spec : row.parameters) {
      std::stringstream choices{std::string(spec.choices)};
      for (std::string choice; std::getline(choices, choice, '|');) {
        SCOPED_TRACE(std::string(row.name) + ":" + std::string(spec.name) + "=" + choice);
        const RawOptions options = {{std::string(spec.name), choice}};
        EXPECT_TRUE(finite(render(row, scene, options).image));
        // A half float keeps three digits of the coefficients.
        const double tolerance = choice == "16" ? 1e-3 : 1e-5;
        if (spec.name == "normalize" && choice == "off") continue;
        EXPECT_LE(max_difference(render(row, single, options).image,
                                 composite(one_layer, single.background)),
                  tolerance);
      }
    }
}

TEST(PropertyMethods, AnyPictureSize) {
  for (const auto& [width, height] : {std::pair(1, 1), {1, 7}, {13, 1}, {63, 65}}) {
    const std::vector<Rgba> layers = {{0.2f, 0.4f, 0.8f, 0.5f}};
    const scene::Scene scene = stack(width, height, layers);
    for (const scene::MethodRow& row : oit_methods()) {
      const Image image = render(row, scene).image;
      EXPECT_EQ(image.pixels.size(), std::size_t(width) * std::size_t(height));
      EXPECT_LE(max_difference(image, composite(layers, scene.background)), 1e-5) << row.name;
    }
  }
}

TEST(PropertyMethods, TheSameRendererGivesTheSamePictureAgain) {
  const scene::Scene scene = triangle_cloud(24, 24, 50, 11);
  for (const scene::MethodRow& row : oit_methods()) {
    const auto renderer = row.make(scene, Parameters(row.name, row.parameters, {}), {});
    const Image first = renderer->render({}).image;
    EXPECT_EQ(max_difference(first, renderer->render({}).image), 0) << row.name;
  }
}

// |n . v| of a sheet seen straight on is 1, of one whose normals lean by 60 degrees 1/2.
TEST(PropertyMethods, HeadlightIsTheCosineOfTheNormal) {
  for (const auto& [normal, cosine] :
       {std::pair(Vec3(0, 0, -1), 1.0), {Vec3(std::sqrt(0.75), 0, 0.5), 0.5}}) {
    scene::Scene scene = stack(3, 3, {{0.8f, 0.6f, 0.4f, 0.5f}});
    scene.lighting = scene::Lighting::headlight;
    for (Vec3& n : scene.objects[0].mesh().normals) n = normal;
    const Vec3 color = 0.5 * cosine * Vec3(0.8, 0.6, 0.4) + 0.5 * scene.background;
    for (const scene::MethodRow& row : oit_methods())
      EXPECT_LE(max_difference(render(row, scene).image, glm::dvec4(color, 0.5)), 1e-5) << row.name;
  }
}

// A sheet through the eye's plane is seen from the eye on: it covers one half of the picture.
TEST(PropertyMethods, WhatLiesBehindTheEyeIsClipped) {
  scene::Scene scene = stack(8, 8, {{1, 1, 1, 0.5f}});
  scene.camera = {.eye = {0, 0, 0}, .target = {0, 0, -1}};
  auto& positions = scene.objects[0].mesh().positions;
  positions = {Vec3(-1e4, -1, 1e4), Vec3(1e4, -1, 1e4), Vec3(1e4, -1, -1e4), Vec3(-1e4, -1, -1e4)};
  for (const scene::MethodRow& row : oit_methods()) {
    const Image image = render(row, scene).image;
    for (int y = 0; y < 8; ++y)
      for (int x = 0; x < 8; ++x)
        EXPECT_NEAR(image.at(x, y).a, y < 4 ? 0 : 0.5, 1e-5) << row.name << ' ' << x << ' ' << y;
  }
}

// Scale and place of a scene change nothing but the roundings of its double coordinates.
TEST(PropertyMethods, ScaleAndPlaceOfTheSceneChangeNothing) {
  const scene::Scene scene = triangle_cloud(32, 32, 20, 14);
  for (const auto& [scale, offset] : {std::pair(1e10, 0.0), {1e-10, 0.0}, {1.0, 1e7}}) {
    scene::Scene moved = scene;
    const auto move = [scale = scale, offset = offset](Vec3& x) { x = scale * x + Vec3(offset); };
    move(moved.camera.eye);
    move(moved.camera.target);
    for (scene::SceneObject& object : moved.objects)
      for (Vec3& x : object.mesh().positions) move(x);
    for (const scene::MethodRow& row : oit_methods()) {
      if (row.name == "stochastic") continue;  // its random numbers are a hash of the depth
      // Coordinates of 1e7 keep 2e-9 of the scene: a vertex may cross a pixel's centre.
      std::size_t changed = 0;
      const Image a = render(row, scene).image, b = render(row, moved).image;
      for (std::size_t i = 0; i < a.pixels.size(); ++i)
        changed += glm::length(a.pixels[i] - b.pixels[i]) > 1e-3f;
      EXPECT_LE(changed, 3u) << row.name << " scale " << scale << " offset " << offset;
    }
  }
}

TEST(PropertyMethods, EveryRowSaysWhatItIs) {
  const scene::Scene scene = stack(2, 2, {{1, 1, 1, 0.5f}});
  for (const scene::MethodRow& row : oit_methods()) {
    EXPECT_FALSE(row.title.empty() || row.citation.empty() || row.equations.empty() ||
                 row.bytes_per_pixel.empty())
        << row.name;
    const auto renderer = row.make(scene, Parameters(row.name, row.parameters, {}), {});
    EXPECT_FALSE(renderer->facts().at("driver").empty());
    EXPECT_FALSE(renderer->explain().empty());
  }
}

}  // namespace
}  // namespace pellucid::oit::test
