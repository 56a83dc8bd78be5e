// SPDX-License-Identifier: GPL-3.0-or-later
// Depth peeling, single and dual: what a budget leaves.
#include <gtest/gtest.h>

#include "tests/oit/oit_pictures.h"

namespace pellucid::oit {
namespace {

using namespace testing;

TEST(UnitMethods, PeelingReportsWhatItsBudgetLeaves) {
  const auto layers = random_layers(9, 0.5f, 4);
  const scene::Scene scene = stack(3, 2, layers);
  const scene::Rendering rendering = render(method("depth-peeling"), scene, {{"peels", "4"}}, true);
  EXPECT_EQ(rendering.stats.fragments, 9u * 6);
  EXPECT_EQ(rendering.stats.stored, 4u * 6);
  EXPECT_EQ(rendering.stats.dropped, 5u * 6);
  EXPECT_EQ(rendering.stats.truncated, 6u);
  const std::vector<Rgba> nearest(layers.begin(), layers.begin() + 4);
  EXPECT_LE(largest_difference(rendering.image, composite(nearest, scene.background)),
            float_composite);
}

// Two layers to a peel: of nine, the third from either side on is left.
TEST(UnitMethods, DualPeelingLeavesTheMiddleToItsBudget) {
  const auto layers = random_layers(9, 0.5f, 4);
  const scene::Scene scene = stack(3, 2, layers);
  const scene::Rendering rendering =
      render(method("dual-depth-peeling"), scene, {{"peels", "2"}}, true);
  EXPECT_EQ(rendering.stats.fragments, 9u * 6);
  EXPECT_EQ(rendering.stats.stored, 4u * 6);
  EXPECT_EQ(rendering.stats.dropped, 5u * 6);
  EXPECT_EQ(rendering.stats.truncated, 6u);
  const std::vector<Rgba> ends = {layers[0], layers[1], layers[7], layers[8]};
  EXPECT_LE(largest_difference(rendering.image, composite(ends, scene.background)),
            float_composite);
}

}  // namespace
}  // namespace pellucid::oit
