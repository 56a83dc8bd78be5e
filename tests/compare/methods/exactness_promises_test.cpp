// SPDX-License-Identifier: GPL-3.0-or-later
// Every row of the method table is as exact as it promises, and tells what it kept and dropped.
#include <gtest/gtest.h>

#include <map>
#include <sstream>
#include <string>

#include "compare/methods/methods.h"
#include "core/options/names.h"
#include "tests/compare/methods/promise_scenes.h"

namespace pellucid::compare {
namespace {

using namespace testing;

// Rows that shift edges alike cover the same pixels; those of others are compared pixel by pixel in
// the tests of agreement.
TEST(PropertyExactness, ExactRowsAgreeWithEachOther) {
  const scene::Scene scene = triangle_cloud(41, 31, 80, 6);
  std::map<double, Image> references;  // by edge_shift
  for (const scene::MethodRow& row : methods()) {
    if (!is_exact(row)) continue;
    const Image image = render(row, scene).image;
    const Image& reference = references.try_emplace(row.promises.edge_shift, image).first->second;
    EXPECT_LE(largest_difference(image, reference), float_composite) << row.name;
  }
  EXPECT_GE(references.size(), 2u);  // ray tracing's edges and rasterization's
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

TEST(PropertyExactness, ExactnessHangsOnTheParametersThatARowNames) {
  const auto layers = random_layers(20, 0.5f, 2);
  // The middle pixel's centre lies on the diagonal of every sheet, a shared edge.
  const scene::Scene scene = shuffled(stack(3, 3, layers), 3);
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

/// So faint that the last of many layers shows.
scene::Scene faint_cloud() {
  scene::Scene scene = triangle_cloud(33, 27, 40, 12);
  for (scene::SceneObject& object : scene.objects)
    for (Rgba& color : object.mesh().colors) color.a *= 0.2f;
  return scene;
}

// The budget is what the deepest pixel needs. Of two orders, and of the lists.
TEST(PropertyExactness, PixelsOfNoMoreLayersThanAreKeptApartAreExactInAnyOrder) {
  const scene::Scene scene = faint_cloud(), other = shuffled(scene, 13);
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

/// The defaults of a row, and every integer at 3: layers exceed it, where it limits them.
std::vector<RawOptions> with_small_budgets(const scene::MethodRow& row) {
  std::vector<RawOptions> options{{}};
  for (const ParameterSpec& spec : row.parameters)
    if (spec.kind == ParameterSpec::Kind::integer && spec.min <= 3 && 3 <= spec.max)
      options.push_back({{std::string(spec.name), "3"}});
  return options;
}

// A layer that the picture does not depend on was dropped: then the stats say so.
TEST(PropertyExactness, NothingIsDroppedInSilence) {
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

/// What a row has kept apart by depth, by its promises.
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
TEST(PropertyExactness, WhatIsKeptApartIsCounted) {
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

}  // namespace
}  // namespace pellucid::compare
