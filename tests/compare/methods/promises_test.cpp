// SPDX-License-Identifier: GPL-3.0-or-later
// Every row of the method table keeps what it promises, whatever the scene.
#include <gtest/gtest.h>

#include <map>
#include <sstream>
#include <string>

#include "compare/methods/methods.h"
#include "core/error.h"
#include "core/options/names.h"
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

// Rows that shift edges alike cover the same pixels; those of others are compared pixel by pixel in
// the tests of agreement.
TEST(PropertyPromises, ExactRowsAgreeWithEachOther) {
  const scene::Scene scene = triangle_cloud(41, 31, 80, 6);
  std::map<double, Image> references;  // by edge_shift
  for (const scene::MethodRow& row : methods()) {
    if (!is_exact(row)) continue;
    const Image image = render(row, scene).image;
    const Image& reference = references.try_emplace(row.promises.edge_shift, image).first->second;
    EXPECT_LE(largest_difference(image, reference), float_composite) << row.name;
  }
  EXPECT_EQ(references.size(), 2u);
}

/// Every choice of the parameters that a row's exactness does not hang on, one at a time.
std::vector<RawOptions> exact_choices(const scene::MethodRow& row) {
  std::vector<RawOptions> options{{}};
  for (const ParameterSpec& spec : row.parameters) {
    std::stringstream choices{std::string(spec.choices)};
    for (std::string choice; std::getline(choices, choice, '|');)
      if (!is_among(spec.name, row.promises.exact_unless))
        options.push_back({{std::string(spec.name), choice}});
    if (spec.kind == ParameterSpec::Kind::integer && spec.min <= 3 && 3 <= spec.max &&
        !is_among(spec.name, row.promises.exact_unless))
      options.push_back({{std::string(spec.name), "3"}});
  }
  return options;
}

TEST(PropertyPromises, ExactnessHangsOnTheParametersThatARowNames) {
  const auto layers = random_layers(20, 0.5f, 2);
  const scene::Scene scene = shuffled(stack(3, 2, layers), 3);
  for (const scene::MethodRow& row : methods()) {
    for (const ParameterSpec& spec : row.parameters)
      EXPECT_TRUE(is_exact(row) || !is_among(spec.name, row.promises.exact_unless)) << row.name;
    if (!is_exact(row)) continue;
    for (const RawOptions& options : exact_choices(row)) {
      SCOPED_TRACE(std::string(row.name) + (options.empty() ? "" : ":" + options.begin()->first));
      EXPECT_LE(largest_difference(render(row, scene, options).image,
                                   composite(layers, scene.background)),
                float_composite);
    }
  }
}

// The budget is a layer more than the deepest pixel needs. Of two orders, and of the lists.
TEST(PropertyPromises, PixelsOfNoMoreLayersThanAreKeptApartAreExactInAnyOrder) {
  const scene::Scene scene = triangle_cloud(33, 27, 40, 12), other = shuffled(scene, 13);
  const scene::Rendering exact =
      render(find_row("method", "linked-list", methods()), scene, {}, true);
  for (const scene::MethodRow& row : methods()) {
    if (row.promises.exact_layers.empty()) continue;
    const RawOptions options = {
        {std::string(row.promises.exact_layers), std::to_string(exact.stats.max_layers)}};
    const Image image = render(row, scene, options).image;
    EXPECT_LE(largest_difference(image, exact.image), float_composite) << row.name;
    EXPECT_EQ(largest_difference(image, render(row, other, options).image), 0) << row.name;
  }
}

TEST(PropertyPromises, TheSettingThatMakesARowExactDoes) {
  const scene::Scene scene = triangle_cloud(33, 27, 40, 12), other = shuffled(scene, 13);
  const Image exact = render(find_row("method", "linked-list", methods()), scene).image;
  for (const scene::MethodRow& row : methods()) {
    if (row.promises.exact_with.empty()) continue;
    const RawOptions options = setting(row.promises.exact_with);
    const Image image = render(row, scene, options).image;
    EXPECT_LE(largest_difference(image, exact), float_composite) << row.name;
    EXPECT_EQ(largest_difference(image, render(row, other, options).image), 0) << row.name;
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

/// The defaults of a row, and every integer at 3: layers exceed it, where it limits them.
std::vector<RawOptions> with_small_budgets(const scene::MethodRow& row) {
  std::vector<RawOptions> options{{}};
  for (const ParameterSpec& spec : row.parameters)
    if (spec.kind == ParameterSpec::Kind::integer && spec.min <= 3 && 3 <= spec.max)
      options.push_back({{std::string(spec.name), "3"}});
  return options;
}

// A layer that the picture does not depend on was dropped: then the stats say so.
TEST(PropertyPromises, NothingIsDroppedInSilence) {
  constexpr int n = 9;
  const std::vector<Rgba> layers(n, Rgba(0.2f, 0.4f, 0.1f, 0.2f));
  const scene::Scene scene = stack(8, 8, layers);
  for (const scene::MethodRow& row : methods())
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
        without_effect += largest_difference(image, all.image) == 0;
      }
      EXPECT_EQ(without_effect > 0, all.stats.dropped > 0) << without_effect << " of 3";
    }
}

/// What a row keeps apart of `n` layers in each of so many pixels.
std::uint64_t kept_apart(const scene::MethodRow& row, const Parameters& parameters,
                         const scene::Rendering& rendering) {
  if (is_exact(row) || row.promises.own_layers)
    return rendering.stats.fragments - rendering.stats.dropped;
  if (row.promises.exact_layers.empty()) return 0;
  std::uint64_t sum = 0;
  for (const std::uint32_t n : rendering.layers.pixels)
    sum += std::min(n, std::uint32_t(parameters.integer(row.promises.exact_layers)));
  return sum;
}

// Nine sheets of depths of their own.
TEST(PropertyPromises, WhatIsKeptApartIsCounted) {
  const scene::Scene scene = stack(8, 8, std::vector<Rgba>(9, Rgba(0.2f, 0.4f, 0.1f, 0.2f)));
  for (const scene::MethodRow& row : methods())
    for (const RawOptions& options : with_small_budgets(row)) {
      SCOPED_TRACE(std::string(row.name) + (options.empty() ? "" : ":" + options.begin()->first));
      const scene::Rendering rendering = render(row, scene, options, true);
      const Parameters parameters(row.name, row.parameters, options);
      EXPECT_EQ(rendering.stats.stored, kept_apart(row, parameters, rendering));
      EXPECT_GT(rendering.stats.total_bytes(), 0u);
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

TEST(PropertyPromises, IsosurfacesAreDrawnOrRefused) {
  const scene::Scene scene = isosurface_scene();
  for (const scene::MethodRow& row : methods()) {
    if (!row.promises.draws_isosurfaces) {
      EXPECT_THROW(render(row, scene), InputError) << row.name;
      continue;
    }
    const Image image = render(row, scene).image;
    // The middle ray enters and leaves; the corners' pass by.
    EXPECT_NEAR(image.at(4, 4).a, 0.75, float_composite) << row.name;
    EXPECT_EQ(image.at(0, 0).a, 0) << row.name;
  }
}

}  // namespace
}  // namespace pellucid::compare
