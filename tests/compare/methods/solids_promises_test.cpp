// SPDX-License-Identifier: GPL-3.0-or-later
// Spheres and tubes, whose crossings every row of the method table finds by casting rays: closed
// forms, then agreement with the ray tracer.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "compare/methods/methods.h"
#include "core/error.h"
#include "core/options/names.h"
#include "tests/compare/methods/solid_scenes.h"

namespace pellucid::compare {
namespace {

using namespace testing;

/// Rows that composite solids exactly; of tubes all but those that merge lines.
bool is_exact_of(const scene::MethodRow& row, bool tubes) {
  return is_exact(row) && !(tubes && row.promises.exact_without_lines && !row.promises.exact);
}

TEST(UnitSolids, ASphereSeenThroughItsMiddleIsTwoLayers) {
  scene::Scene scene = empty_scene(1, 1);
  const Rgba color(0.9, 0.2, 0.4, 0.3);
  scene.objects = {spheres({{0, 0, 0}}, 0.8, {color})};
  for (const scene::MethodRow& row : methods()) {
    const scene::Rendering rendering = render(row, scene, {}, true);
    EXPECT_EQ(rendering.stats.fragments, 2u) << row.name;
    EXPECT_EQ(rendering.stats.dropped, 0u) << row.name;
    if (!is_exact(row)) continue;
    EXPECT_NEAR(rendering.image.pixels[0].a, 1 - 0.7 * 0.7, 1e-6) << row.name;  // roundings of 6e-8
    EXPECT_LE(largest_difference(rendering.image, composite({color, color}, scene.background)),
              float_composite)
        << row.name;
  }
}

// In a picture of 4 × 1 pixels centres are 1/4 and 3/4 from the middle: √(1 - c²) of the radius 1.
TEST(UnitSolids, ASphereIsLitByItsNormalOnBothSides) {
  scene::Scene scene = empty_scene(4, 4);
  scene.lighting = scene::Lighting::headlight;
  const Rgba color(0.9, 0.2, 0.4, 0.3);
  scene.objects = {spheres({{0, 0.25, 0}}, 1, {color})};
  for (const scene::MethodRow& row : methods()) {
    if (!is_exact(row)) continue;
    const Image image = render(row, scene).image;
    for (int x = 0; x < 4; ++x) {
      const double c = std::sqrt(1 - std::pow((x + 0.5) / 2 - 1, 2));
      const Rgba lit(Vec3(color) * c, color.a);
      const glm::dvec4 expected = composite({lit, lit}, scene.background);
      // The second row's centres are 1/4 above the middle, as the sphere's is.
      EXPECT_LE(glm::length(glm::dvec4(image.at(x, 1)) - expected), float_composite) << row.name;
    }
  }
}

// Colours go from red to green along the axis; at pixel centres, y = -1/4 and 1/4, the tube of
// radius 1/2 has the cosine √(3/4). Its joints are inside of it.
TEST(UnitSolids, ATubeAcrossIsTwoLayersOfItsLinesColour) {
  scene::Scene scene = empty_scene(4, 4);
  scene.lighting = scene::Lighting::headlight;
  scene.objects = {
      tube({{-1, 0, 0}, {-0.1, 0, 0}, {0, 0, 0}, {1, 0, 0}}, 0.5,
           {{1, 0, 0, 0.4}, {0.55, 0.45, 0, 0.4}, {0.5, 0.5, 0, 0.4}, {0, 1, 0, 0.4}})};
  for (const scene::MethodRow& row : methods()) {
    const scene::Rendering rendering = render(row, scene, {}, true);
    EXPECT_EQ(rendering.stats.fragments, 16u) << row.name;
    if (!is_exact_of(row, true)) continue;
    for (int x = 0; x < 4; ++x) {
      const double along = (x + 0.5) / 4, c = std::sqrt(0.75);
      const Rgba lit(c * (1 - along), c * along, 0, 0.4);
      const glm::dvec4 expected = composite({lit, lit}, scene.background);
      EXPECT_LE(glm::length(glm::dvec4(rendering.image.at(x, 2)) - expected), float_composite)
          << row.name << ' ' << x;
    }
  }
}

TEST(UnitSolids, ATubeAlongTheRayIsEnteredAndLeftOnce) {
  scene::Scene scene = empty_scene(1, 1);
  const Rgba color(0.9, 0.2, 0.4, 0.3);
  scene.objects = {tube({{0, 0, 0.5}, {0, 0, 0.1}, {0, 0, -0.4}}, 0.3, {color, color, color})};
  for (const scene::MethodRow& row : methods())
    EXPECT_EQ(render(row, scene, {}, true).stats.fragments, 2u) << row.name;
}

// Sheets a ten-thousandth of the radius before and behind where the ray enters and leaves: d has
// 6e-8 of the range of two radii. From a distance of ten million radii, too.
TEST(UnitSolids, DepthsAreThoseOfTheSurface) {
  const std::vector<Rgba> layers = random_layers(6, 0.9f, 8);
  for (const double distance : {4.0, 1e3, 1e7}) {
    scene::Scene scene = empty_scene(1, 1);
    scene.camera = {.eye = {0, 0, distance}, .target = {0, 0, 0}, .fov = 60 / distance};
    scene.objects = {spheres({{0, 0, 0}}, 1, {layers[1]})};
    const double shift = std::max(1e-4, 1e-16 * distance);
    int i = 0;
    for (const double z : {1 + shift, 1 - shift, -1 + shift, -1 - shift})
      scene.objects.push_back(sheet(z, layers[std::size_t(std::array{0, 2, 3, 5}[i++])]));
    const std::vector<Rgba> order = {layers[0], layers[1], layers[2],
                                     layers[3], layers[1], layers[5]};
    for (const scene::MethodRow& row : methods())
      if (is_exact(row)) {
        EXPECT_LE(largest_difference(render(row, scene).image, composite(order, scene.background)),
                  float_composite)
            << row.name << ' ' << distance;
      }
  }
}

class AgreementSolids : public ::testing::TestWithParam<SolidScene> {};

TEST_P(AgreementSolids, EveryRowFindsTheCrossingsOfTheRayTracer) {
  const scene::Scene scene = GetParam().make();
  const scene::Rendering truth = render(find_row("method", "raytrace", methods()), scene, {}, true);
  EXPECT_GT(truth.stats.max_layers, 3u);
  const std::size_t pixels = truth.image.pixels.size();
  for (const scene::MethodRow& row : methods()) {
    if (row.promises.own_layers) continue;
    const scene::Rendering other = render(row, scene, {}, true);
    std::size_t same = 0;
    double largest = 0;
    for (std::size_t i = 0; i < pixels; ++i) {
      same += other.layers.pixels[i] == truth.layers.pixels[i];
      if (!GetParam().solids_alone && other.layers.pixels[i] != truth.layers.pixels[i]) continue;
      largest =
          std::max<double>(largest, glm::length(other.image.pixels[i] - truth.image.pixels[i]));
    }
    // Rays are cast in double at the very pixel centres; triangles and discs are rasterized.
    if (scene.samples.is_center()) {  // else raytrace counts those of the sample that has most
      const double least = GetParam().solids_alone ? 1 : 0.98;
      EXPECT_GE(double(same), least * double(pixels)) << row.name;
    }
    // Two crossings nearer to each other than 1e-7 of the range are few, and there are none.
    if (is_exact_of(row, true)) {
      EXPECT_LE(largest, float_composite) << row.name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Of, AgreementSolids, ::testing::ValuesIn(solid_scenes()),
                         [](const auto& of) { return std::string(of.param.name); });

TEST(PropertySolids, OrderOfObjectsChangesNoMoreThanPromised) {
  const scene::Scene scene = mixed_with_others(), shuffled = compare::shuffled(scene, 5);
  for (const scene::MethodRow& row : methods())
    EXPECT_LE(largest_difference(render(row, scene).image, render(row, shuffled).image),
              row.promises.order_independent ? 0 : row.promises.order_spread)
        << row.name;
}

// What is beside the picture or behind the eye costs nothing and changes nothing.
TEST(PropertySolids, WhatIsNotInThePictureIsNotDrawn) {
  scene::Scene scene = empty_scene(8, 6);
  scene.camera = {.eye = {0, 0, 3}, .target = {0, 0, 0}};
  const Rgba color(0.9, 0.2, 0.4, 0.3);
  scene.objects = {sheet(0, color), spheres({{0, 0, 5}, {30, 0, 0}}, 1, {color, color}),
                   tube({{-5, 0, 4}, {5, 0, 4}}, 0.5, {color, color})};
  for (const scene::MethodRow& row : methods())
    EXPECT_EQ(render(row, scene, {}, true).stats.fragments, 48u) << row.name;
}

TEST(UnitSolids, TubesThatWindTooCloseAreRefusedInOneLine) {
  scene::Scene scene = empty_scene(2, 2);
  std::vector<Vec3> points;
  for (int i = 0; i < 4200; ++i) points.emplace_back(1e-6 * i, 0, 0);
  scene.objects = {tube(points, 0.5, std::vector<Rgba>(points.size(), Rgba(0.5)))};
  try {
    render(find_row("method", "linked-list", methods()), scene);
    ADD_FAILURE() << "drawn";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("raytrace draws it"), std::string::npos);
  }
}

}  // namespace
}  // namespace pellucid::compare
