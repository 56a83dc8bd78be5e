// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

#include "core/options/names.h"
#include "oit/registry.h"
#include "tests/support/pictures.h"
#include "tests/support/scenes.h"

namespace pellucid::oit::testing {

using namespace pellucid::testing;

inline const scene::MethodRow& method(std::string_view name) {
  return find_row("method", name, oit_methods());
}

/// Holds a method to the exact composite of n layers.
inline void expect_exact_stack(const scene::MethodRow& row, int n,
                               double tolerance = float_composite) {
  SCOPED_TRACE(std::string(row.name) + " layers " + std::to_string(n));
  auto layers = random_layers(n, n < 100 ? 1.0f : 10.0f / float(n), 1);
  scene::Scene scene = stack(3, 2, layers);
  // Submitted in an order of no meaning; the sheets' depths decide.
  std::shuffle(scene.objects.begin(), scene.objects.end(), std::mt19937(2));
  const scene::Rendering rendering = render(row, scene, {}, true);
  EXPECT_EQ(rendering.stats.max_layers, unsigned(n));
  EXPECT_EQ(rendering.stats.fragments, std::uint64_t(n) * 6);
  EXPECT_EQ(rendering.stats.dropped, 0u);
  // About sqrt(n) roundings of 6e-8 remain of n: 6e-6 for 10^4 layers.
  EXPECT_LE(largest_difference(rendering.image, composite(layers, scene.background)), tolerance);
}

}  // namespace pellucid::oit::testing
