// SPDX-License-Identifier: GPL-3.0-or-later
// What every row of the method table does with any scene, picture and camera.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>

#include "compare/methods/methods.h"
#include "scene/view/pixel_samples.h"
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

/// Equal but for three pixels; of a row that is random, equal in the mean.
void expect_same(const scene::MethodRow& row, const Image& a, const Image& b) {
  const double pixels = double(a.pixels.size());
  std::size_t changed = 0;
  glm::dvec4 mean(0);
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const Rgba difference = a.pixels[i] - b.pixels[i];
    changed += glm::length(difference) > 1e-3f;
    mean += glm::dvec4(difference) / pixels;
  }
  EXPECT_LE(changed, row.promises.random ? a.pixels.size() : 3u);
  // A channel's deviation is at most 1/2, a difference's √2 as much, and six of the mean's are:
  const double noise = row.promises.random ? 6 * 0.5 * std::sqrt(2 / pixels) : 3.0 / pixels;
  for (int c = 0; c < 4; ++c) EXPECT_NEAR(mean[c], 0, noise);
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

/// Seen by a camera that has moved by so many pixels to the right and down.
scene::Scene seen_from(scene::Scene scene, const Vec2& pixels) {
  const double size = scene.camera.height / scene.height;
  const Vec3 shift(size * pixels.x, -size * pixels.y, 0);
  scene.camera.eye += shift;
  scene.camera.target += shift;
  return scene;
}

// Sampled at its centre, a pixel of a camera moved by s - 1/2 shows what is at s.
TEST(PropertyMethods, APixelIsTheMeanOfItsSamples) {
  scene::Scene scene = with_importance(triangle_cloud(16, 16, 12, 16));
  scene.camera = empty_scene(16, 16).camera;
  for (const scene::MethodRow& row : methods()) {
    SCOPED_TRACE(row.name);
    Image mean(16, 16, Rgba(0));
    for (const Vec2& sample : scene::pixel_samples(2)) {
      const Image one = render(row, seen_from(scene, sample - 0.5)).image;
      for (std::size_t i = 0; i < one.pixels.size(); ++i) mean.pixels[i] += 0.25f * one.pixels[i];
    }
    scene::Scene sampled = scene;
    sampled.samples = 2;
    expect_same(row, mean, render(row, sampled).image);
  }
}

/// By how much p lies to the left of the line from a to b; all in pixels, y down.
double left_of(const Vec2& a, const Vec2& b, const Vec2& p) {
  const Vec2 along = glm::normalize(b - a);
  return along.y * (p.x - a.x) - along.x * (p.y - a.y);
}

// In a picture of 64 × 64 pixels of one unit, of triangles at depths of their own: how many cover a
// pixel's centre is known but for those that have an edge within edge_shift.
TEST(PropertyMethods, PixelsAreCoveredWhereTheirCentresLieInside) {
  scene::Scene scene = empty_scene(64, 64);
  scene.camera.height = 64;
  std::mt19937 random(17);
  std::uniform_real_distribution<double> place(-4, 68);
  std::vector<std::array<Vec2, 3>> triangles(40);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    geometry::TriangleMesh mesh;
    for (Vec2& corner : triangles[i]) {
      corner = Vec2(place(random), place(random));
      mesh.positions.emplace_back(corner.x - 32, 32 - corner.y, 0.05 * double(i));
      mesh.normals.emplace_back(0, 0, 1);
      mesh.colors.emplace_back(0.5f);
    }
    mesh.triangles = {{0, 1, 2}};
    scene.objects.push_back({"triangle", mesh});
    if (left_of(triangles[i][0], triangles[i][1], triangles[i][2]) < 0)
      std::swap(triangles[i][1], triangles[i][2]);
  }
  for (const scene::MethodRow& row : methods()) {
    const CountImage layers = render(row, scene, {}, true).layers;
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) {
        std::uint32_t inside = 0, near = 0;
        for (const auto& [a, b, c] : triangles) {
          const Vec2 p(x + 0.5, y + 0.5);
          const double depth = std::min({left_of(a, b, p), left_of(b, c, p), left_of(c, a, p)});
          inside += depth > row.promises.edge_shift;
          near += std::abs(depth) <= row.promises.edge_shift;
        }
        ASSERT_GE(layers.at(x, y), inside) << row.name << ' ' << x << ' ' << y;
        ASSERT_LE(layers.at(x, y), inside + near) << row.name << ' ' << x << ' ' << y;
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
