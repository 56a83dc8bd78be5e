// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/traversal/crossing_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <random>

namespace pellucid::groundtruth {
namespace {

using Depths = std::function<double(std::mt19937&)>;

double uniform(std::mt19937& random) {
  return std::uniform_real_distribution<double>(1, 2)(random);
}

/// Distributions that fill buckets evenly, all into one, and into none.
const std::pair<const char*, Depths> distributions[] = {
    {"uniform", uniform},
    {"equal", [](std::mt19937&) { return 1.5; }},
    {"few values", [](std::mt19937& random) { return 1 + double(random() % 5); }},
    {"one far away",
     [](std::mt19937& random) { return random() % 20 == 0 ? 1e9 : uniform(random); }},
    {"one at infinity",
     [](std::mt19937& random) {
       return random() % 20 == 0 ? std::numeric_limits<double>::infinity() : uniform(random);
     }},
    {"an ulp apart",
     [](std::mt19937& random) {
       return random() % 2 ? 1.0 : 1 + std::numeric_limits<double>::epsilon();
     }},
    {"subnormal span", [](std::mt19937& random) { return double(random() % 3) * 5e-324; }}};

TEST(PropertyCrossingOrder, SortsLikeTheComparison) {
  std::mt19937 random(7);
  for (const auto& [name, depth] : distributions)
    for (const std::size_t n : {0, 1, 2, 11, 12, 13, 64, 511, 512, 513, 2000}) {
      std::vector<Crossing> crossings(n);
      for (Crossing& c : crossings)
        c = {depth(random), uniform(random), uniform(random), std::uint32_t(random() % 3),
             std::uint32_t(random() % 50)};
      std::vector<Crossing> expected = crossings;
      std::stable_sort(expected.begin(), expected.end());
      order_crossings(crossings);
      ASSERT_EQ(crossings.size(), n) << name;
      for (std::size_t i = 0; i < n; ++i) {
        // Crossings that compare equal may lie in any order.
        EXPECT_FALSE(crossings[i] < expected[i] || expected[i] < crossings[i])
            << name << ", crossing " << i << " of " << n;
      }
    }
}

}  // namespace
}  // namespace pellucid::groundtruth
