// SPDX-License-Identifier: GPL-3.0-or-later
// What every row of the method table does with any scene, picture and camera.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>

#include "compare/methods/methods.h"
#include "core/parallel.h"
#include "tests/compare/methods/promise_scenes.h"

namespace pellucid::compare {
namespace {

using namespace testing;

bool finite(const Image& image) {
  for (const Rgba& pixel : image.pixels)
    for (int c = 0; c < 4; ++c)
      if (!std::isfinite(pixel[c])) return false;
  return true;
}

TEST(PropertyMethods, NothingVisibleIsTheBackground) {
  scene::Scene scene = empty_scene(4, 3);
  scene.objects = {sheet(0, {1, 1, 1, 1})};
  for (Vec3& x : scene.objects[0].mesh().positions) x.x += 100;
  const glm::dvec4 expected(scene.background, 0);
  for (const scene::MethodRow& row : methods())
    // A rounding of the background to float, and one of its share of 1.
    EXPECT_LE(largest_difference(render(row, scene).image, expected), 1e-7) << row.name;
}

TEST(PropertyMethods, OpacityZeroIsTheBackground) {
  scene::Scene scene = triangle_cloud(16, 16, 40, 9);
  for (scene::SceneObject& object : scene.objects)
    for (Rgba& color : object.mesh().colors) color.a = 0;
  const glm::dvec4 expected(scene.background, 0);
  for (const scene::MethodRow& row : methods())
    // As above.
    EXPECT_LE(largest_difference(render(row, scene).image, expected), 1e-7) << row.name;
}

TEST(PropertyMethods, PicturesAreFinite) {
  for (const float alpha : {1e-8f, 0.9999f, 1 - 1e-7f, 1.0f}) {
    scene::Scene scene = triangle_cloud(16, 9, 200, 10);
    for (scene::SceneObject& object : scene.objects)
      for (Rgba& color : object.mesh().colors) color.a = alpha;
    for (const scene::MethodRow& row : methods())
      EXPECT_TRUE(finite(render(row, scene).image)) << row.name << " alpha " << alpha;
  }
}

/// Whoever asked for a picture may end it, at any report; the next one is as if nothing had been.
TEST(PropertyMethods, APictureThatWasEndedLeavesNothingBehind) {
  const scene::Scene scene = with_importance(triangle_cloud(16, 9, 60, 12));
  for (const scene::MethodRow& row : methods()) {
    const auto renderer = row.make(scene, Parameters(row.name, row.parameters, {}), {});
    int reports = 0;
    const auto whole = renderer->render({.progress = [&](double, std::string_view) { ++reports; }});
    EXPECT_GT(reports, 0) << row.name << " never asks";
    for (const int last : {1, 1 + reports / 2, reports}) {
      int left = last;
      const auto end = [&](double, std::string_view) {
        if (--left == 0) throw Cancelled();
      };
      EXPECT_THROW(renderer->render({.progress = end}), Cancelled) << row.name;
    }
    EXPECT_EQ(renderer->render({}).image.pixels, whole.image.pixels) << row.name;
  }
}

TEST(PropertyMethods, EveryChoiceOfEveryParameterDraws) {
  const scene::Scene scene = triangle_cloud(16, 9, 100, 13);
  const std::vector<Rgba> one_layer = {{0.2f, 0.4f, 0.8f, 0.5f}};
  const scene::Scene single = stack(4, 4, one_layer);
  for (const scene::MethodRow& row : methods())
    for (const ParameterSpec& spec : row.parameters) {
      std::stringstream choices{std::string(spec.choices)};
      for (std::string choice; std::getline(choices, choice, '|');) {
        SCOPED_TRACE(std::string(row.name) + ":" + std::string(spec.name) + "=" + choice);
        const RawOptions options = {{std::string(spec.name), choice}};
        EXPECT_TRUE(finite(render(row, scene, options).image));
        if (options == setting(row.promises.one_layer_unless)) continue;
        // A half float's ulp is 2^-10 of a coefficient; a rounding is half of that, and of the
        // coefficients of one layer's depth, at most 1 each, the largest error counts.
        const double tolerance = choice == "16" ? 1e-3 : float_composite;
        EXPECT_LE(largest_difference(render(row, single, options).image,
                                     composite(one_layer, single.background)),
                  tolerance);
      }
    }
}

TEST(PropertyMethods, AnyPictureSize) {
  for (const auto& [width, height] : {std::pair(1, 1), {1, 7}, {13, 1}, {63, 65}}) {
    const std::vector<Rgba> layers = {{0.2f, 0.4f, 0.8f, 0.5f}};
    const scene::Scene scene = stack(width, height, layers);
    for (const scene::MethodRow& row : methods()) {
      const Image image = render(row, scene).image;
      EXPECT_EQ(image.pixels.size(), std::size_t(width) * std::size_t(height));
      EXPECT_LE(largest_difference(image, composite(layers, scene.background)), float_composite)
          << row.name;
    }
  }
}

TEST(PropertyMethods, TheSameRendererGivesTheSamePictureAgain) {
  const scene::Scene scene = triangle_cloud(24, 24, 50, 11);
  for (const scene::MethodRow& row : methods()) {
    const auto renderer = row.make(scene, Parameters(row.name, row.parameters, {}), {});
    const Image first = renderer->render({}).image;
    EXPECT_EQ(largest_difference(first, renderer->render({}).image), 0) << row.name;
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
    for (const scene::MethodRow& row : methods())
      EXPECT_LE(largest_difference(render(row, scene).image, glm::dvec4(color, 0.5)),
                float_composite)
          << row.name;
  }
}

/// A sheet over a third of the picture, whose normals lean by 60 degrees: c is 1/2.
scene::SceneObject leaning_sheet(double left, std::optional<scene::Lighting> lighting) {
  scene::SceneObject third{"third",
                           rectangle(left, left + 2.0 / 3, -1, 1, 0, {0.8f, 0.6f, 0.4f, 0.5f})};
  third.mesh().normals.assign(4, Vec3(std::sqrt(0.75), 0, 0.5));
  third.lighting = lighting;
  return third;
}

// Unlit, 1/2, and 0.15 + 0.85 / 2 without a highlight, whatever the scene's light; an object
// without one has the scene's, and one that is not lit needs no normals.
TEST(PropertyMethods, AnObjectsOwnLightGoesBeforeTheScenes) {
  using scene::Lighting;
  const auto lit = [](double factor) { return 0.5 * factor * Vec3(0.8, 0.6, 0.4); };
  const double factors[] = {1, 0.5, 0.575};
  for (const Lighting of_scene : {Lighting::none, Lighting::headlight, Lighting::phong}) {
    scene::Scene scene = stack(3, 3, {});
    scene.lighting = of_scene;
    scene.objects = {leaning_sheet(-1, Lighting::none), leaning_sheet(-1.0 / 3, std::nullopt),
                     leaning_sheet(1.0 / 3, Lighting::phong)};
    scene.objects[0].mesh().normals.clear();
    if (of_scene == Lighting::none) scene.objects[1].mesh().normals.clear();
    for (const scene::MethodRow& row : methods()) {
      const Image image = render(row, scene).image;
      const double expected[] = {1, factors[std::size_t(of_scene)], 0.575};
      for (int x = 0; x < 3; ++x)
        for (int c = 0; c < 3; ++c)
          EXPECT_NEAR(image.at(x, 1)[c], lit(expected[x])[c] + 0.5 * scene.background[c],
                      float_composite)
              << row.name << ' ' << x;
    }
  }
}

// A sheet through the eye's plane is seen from the eye on: it covers one half of the picture.
TEST(PropertyMethods, WhatLiesBehindTheEyeIsClipped) {
  scene::Scene scene = stack(8, 8, {{1, 1, 1, 0.5f}});
  scene.camera = {.eye = {0, 0, 0}, .target = {0, 0, -1}};
  auto& positions = scene.objects[0].mesh().positions;
  positions = {Vec3(-1e4, -1, 1e4), Vec3(1e4, -1, 1e4), Vec3(1e4, -1, -1e4), Vec3(-1e4, -1, -1e4)};
  for (const scene::MethodRow& row : methods()) {
    const Image image = render(row, scene).image;
    for (int y = 0; y < 8; ++y)
      for (int x = 0; x < 8; ++x)
        EXPECT_NEAR(image.at(x, y).a, y < 4 ? 0 : 0.5, float_composite)
            << row.name << ' ' << x << ' ' << y;
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
    for (const scene::MethodRow& row : methods()) {
      // Coordinates of 1e7 keep 2e-9 of the scene: a vertex may cross a pixel's centre.
      SCOPED_TRACE(::testing::Message() << row.name << " scale " << scale << " offset " << offset);
      expect_same(row, render(row, scene).image, render(row, moved).image);
    }
  }
}

TEST(PropertyMethods, EveryRowSaysWhatItIs) {
  const scene::Scene scene = stack(2, 2, {{1, 1, 1, 0.5f}});
  for (const scene::MethodRow& row : methods()) {
    EXPECT_FALSE(row.title.empty() || row.citation.empty() || row.equations.empty() ||
                 row.bytes_per_pixel.empty())
        << row.name;
    const auto renderer = row.make(scene, Parameters(row.name, row.parameters, {}), {});
    EXPECT_FALSE(renderer->facts().empty());
    for (const auto& [name, fact] : renderer->facts()) EXPECT_FALSE(fact.empty()) << name;
    EXPECT_FALSE(renderer->explain().empty());
  }
}

}  // namespace
}  // namespace pellucid::compare
