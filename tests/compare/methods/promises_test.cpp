// SPDX-License-Identifier: GPL-3.0-or-later
// Every row of the method table keeps what it promises, whatever the scene.
#include <gtest/gtest.h>

#include <memory>

#include "compare/methods/methods.h"
#include "core/error.h"
#include "tests/compare/methods/promise_scenes.h"
#include "tests/support/levels.h"

namespace pellucid::compare {
namespace {

using namespace testing;

TEST(PropertyPromises, OrderOfPrimitivesChangesNoMoreThanPromised) {
  const scene::Scene scene = triangle_cloud(37, 23, 60, 4), other = shuffled(scene, 5);
  for (const scene::MethodRow& row : methods()) {
    const double difference =
        largest_difference(render(row, scene).image, render(row, other).image);
    EXPECT_LE(difference, row.promises.order_independent ? 0 : row.promises.order_spread)
        << row.name;
  }
}

TEST(PropertyPromises, DrawsDifferWhereTheyAreMadeOfRandomNumbersAndNowhereElse) {
  const scene::Scene scene = triangle_cloud(24, 18, 40, 4);
  for (const scene::MethodRow& row : methods()) {
    const auto renderer = row.make(scene, Parameters(row.name, row.parameters, {}), {});
    const Image first = renderer->render({.draw = 0}).image;
    EXPECT_EQ(largest_difference(first, renderer->render({.draw = 1}).image) > 0,
              row.promises.random)
        << row.name;
    EXPECT_EQ(largest_difference(first, renderer->render({.draw = 0}).image), 0) << row.name;
  }
}

TEST(PropertyPromises, ColoursStayInTheirHull) {
  // Red and green layers over a background of blue 0.9: no method may make blue of them, or white.
  std::vector<Rgba> layers = random_layers(30, 1.0f, 7);
  for (Rgba& layer : layers) layer = {layer.r > 0.5f, layer.r <= 0.5f, 0, layer.a};
  scene::Scene scene = stack(3, 3, layers);
  scene.background = {0, 0, 0.9};
  for (const scene::MethodRow& row : methods()) {
    if (!row.promises.convex_hull) continue;
    const Image image = render(row, scene).image;
    for (const Rgba& pixel : image.pixels) {
      // Barycentric coordinates of red, green and the background.
      EXPECT_NEAR(pixel.r + pixel.g + pixel.b / 0.9f, 1, float_composite) << row.name;
      EXPECT_GE(std::min({pixel.r, pixel.g, pixel.b}), -1e-6f) << row.name;
    }
  }
}

TEST(PropertyPromises, FixedMemoryDependsOnThePictureAlone) {
  for (const scene::MethodRow& row : methods()) {
    if (!row.promises.fixed_memory) continue;
    const auto few = render(row, triangle_cloud(20, 10, 3, 8)).stats.total_bytes();
    const auto many = render(row, triangle_cloud(20, 10, 300, 8)).stats.total_bytes();
    EXPECT_EQ(few, many) << row.name;
    EXPECT_GT(few, 0u) << row.name;
  }
}

TEST(PropertyPromises, ImportanceChangesTheOpacitiesOfTheRowsThatOptimizeThemAlone) {
  const scene::Scene scene = triangle_cloud(24, 18, 40, 15), important = with_importance(scene);
  for (const scene::MethodRow& row : methods())
    EXPECT_EQ(largest_difference(render(row, scene).image, render(row, important).image) > 0.01,
              row.promises.optimizes_opacity)
        << row.name;
}

/// The sphere of radius 1, of opacity 1/2.
scene::Scene isosurface_scene() {
  scene::Scene scene = empty_scene(9, 9);
  scene::Isosurface surface;
  surface.field = std::make_shared<const fields::LevelField>(
      std::vector{sampled(Vec3(-2), 0.25, 17, [](const Vec3& x) { return glm::dot(x, x); })},
      fields::find_reconstruction("blend"));
  surface.value = 1;
  surface.corners = scene::corners_of(surface.field->bounds());
  surface.corners.colors.assign(8, Rgba(0.9, 0.4, 0.1, 0.5));
  scene.objects.push_back({"sphere", surface});
  return scene;
}

TEST(PropertyPromises, IsosurfacesAreDrawn) {
  const scene::Scene scene = isosurface_scene();
  for (const scene::MethodRow& row : methods()) {
    const Image image = render(row, scene).image;
    // The middle ray enters and leaves; the corners' pass by.
    EXPECT_GT(image.at(4, 4).a, 0.4) << row.name;
    EXPECT_EQ(image.at(0, 0).a, 0) << row.name;
    if (row.promises.exact || row.promises.in_double) {
      EXPECT_NEAR(image.at(4, 4).a, 0.75, float_composite) << row.name;
    }
  }
}

}  // namespace
}  // namespace pellucid::compare
