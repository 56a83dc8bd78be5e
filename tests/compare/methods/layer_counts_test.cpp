// SPDX-License-Identifier: GPL-3.0-or-later
// Every row of the method table counts the layers that are there, what is opaque among them.
#include <gtest/gtest.h>

#include <numeric>
#include <string>

#include "compare/methods/methods.h"
#include "core/options/names.h"
#include "tests/compare/methods/promise_scenes.h"

namespace pellucid::compare {
namespace {

using namespace testing;

/// Seven sheets; an opaque one between the third and the fourth covers the right half, another one
/// behind it all.
scene::Scene sheets_and_opaque_ones() {
  scene::Scene scene = stack(8, 6, random_layers(7, 0.5f, 41));
  scene.objects.push_back({"half", rectangle(0.01, 50, -50, 50, 0.05, Rgba(0.2f, 0.9f, 0.4f, 1))});
  scene.objects.push_back(sheet(-2, Rgba(0.5f, 0.1f, 0.7f, 1)));
  for (std::size_t i = 7; i < 9; ++i) scene.objects[i].opaque = true;
  return shuffled(scene, 42);
}

/// Merged within no distance, every fragment is a layer.
RawOptions as_many_layers(const scene::MethodRow& row) {
  return row.promises.own_layers ? RawOptions{{"epsilon2", "0"}} : RawOptions{};
}

TEST(PropertyLayerCounts, WhatIsOpaqueIsALayerInEveryMethod) {
  const scene::Scene scene = sheets_and_opaque_ones();
  const scene::Rendering exact = render(find_row("method", "raytrace", methods()), scene, {}, true);
  const auto& layers = exact.layers.pixels;
  EXPECT_EQ(layers.front(), 8u);  // seven and the last; on the right those before the half, and it
  EXPECT_LT(layers.back(), 8u);
  for (const scene::MethodRow& row : methods()) {
    const scene::Rendering drawn = render(row, scene, as_many_layers(row), true);
    EXPECT_EQ(drawn.layers.pixels, layers) << row.name;
    EXPECT_EQ(drawn.stats.fragments, std::accumulate(layers.begin(), layers.end(), 0u)) << row.name;
    EXPECT_EQ(drawn.stats.max_layers, 8u) << row.name;
  }
}

TEST(PropertyLayerCounts, FragmentsAreThoseOfAllSamples) {
  scene::Scene scene = sheets_and_opaque_ones();
  const std::uint64_t of_one =
      render(find_row("method", "raytrace", methods()), scene, {}, true).stats.fragments;
  scene.samples.per_axis = 2;
  for (const scene::MethodRow& row : methods())
    EXPECT_EQ(render(row, scene, as_many_layers(row), true).stats.fragments, 4 * of_one)
        << row.name;
}

}  // namespace
}  // namespace pellucid::compare
