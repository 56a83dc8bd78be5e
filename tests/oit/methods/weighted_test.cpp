// SPDX-License-Identifier: GPL-3.0-or-later
// Weighted sum and average are their formulas.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/oit/oit_pictures.h"

namespace pellucid::oit {
namespace {

using namespace testing;

TEST(UnitMethods, WeightedSumIsItsFormula) {
  const auto layers = random_layers(5, 0.15f, 5);
  Vec3 color(0);
  double opacity = 0;
  for (const Rgba& layer : layers) {
    color += double(layer.a) * Vec3(layer);
    opacity += layer.a;
  }
  const scene::Scene scene = stack(2, 2, layers);
  const glm::dvec4 expected(color + (1 - opacity) * scene.background, opacity);
  // Five sums of products up to 1: ten roundings of 6e-8.
  EXPECT_LE(largest_difference(render(method("weighted-sum"), scene).image, expected), 6e-7);
}

TEST(UnitMethods, WeightedAverageIsItsFormula) {
  const auto layers = random_layers(9, 0.8f, 3);
  Vec3 colors(0);
  double opacities = 0;
  for (const Rgba& layer : layers) {
    colors += double(layer.a) * Vec3(layer);
    opacities += layer.a;
  }
  const double transmittance = std::pow(1 - opacities / 9, 9);
  const scene::Scene scene = stack(2, 2, layers);
  const glm::dvec4 expected(
      (1 - transmittance) * colors / opacities + transmittance * scene.background,
      1 - transmittance);
  EXPECT_LE(largest_difference(render(method("weighted-average"), scene).image, expected),
            float_composite);
}

}  // namespace
}  // namespace pellucid::oit
