// SPDX-License-Identifier: GPL-3.0-or-later
// The guide's recipe for a method, followed: what it names is all that a method takes.
#include "tests/oit/methods/toy/color_filter.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/error.h"
#include "tests/oit/oit_pictures.h"

namespace pellucid::oit {
namespace {

using namespace testing;

/// The registry with the recipe's one line more.
std::vector<scene::MethodRow> rows() {
  std::vector<scene::MethodRow> rows(oit_methods().begin(), oit_methods().end());
  rows.push_back(color_filter_method());
  return rows;
}

/// The formula of color_filter.h, in double.
glm::dvec4 filtered(const std::vector<Rgba>& layers, const Vec3& background, double strength) {
  glm::dvec4 passed(1);
  for (const Rgba& layer : layers)
    passed *= 1.0 - double(layer.a) * glm::dvec4(strength * (1.0 - Vec3(layer)), 1);
  return {Vec3(passed) * background, 1 - passed.a};
}

TEST(UnitToyMethod, IsFoundByItsNameAndNamedInMessages) {
  EXPECT_EQ(find_row("method", "color-filter", rows()).title, "Colour filters");
  try {
    find_row("method", "colour-filter", rows());
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("known: color-filter"), std::string::npos);
  }
}

TEST(UnitToyMethod, DrawsItsFormula) {
  const scene::MethodRow row = find_row("method", "color-filter", rows());
  for (const int n : {1, 7, 40}) {
    const std::vector<Rgba> layers = random_layers(n, 0.6f, 5);
    const scene::Scene scene = stack(5, 4, layers);
    for (const auto& [text, strength] : {std::pair("1", 1.0), std::pair("0.25", 0.25)}) {
      const Image image = render(row, scene, {{"strength", text}}).image;
      // n products of floats below 1: n roundings of 6e-8, of the factor and of the product.
      EXPECT_LE(largest_difference(image, filtered(layers, scene.background, strength)),
                2 * n * 6e-8 + 1e-7)
          << n << ' ' << text;
    }
  }
}

TEST(UnitToyMethod, KeepsItsPromises) {
  const scene::MethodRow row = find_row("method", "color-filter", rows());
  scene::Scene scene = stack(5, 4, random_layers(30, 0.6f, 6));
  const scene::Rendering in_order = render(row, scene);
  std::ranges::reverse(scene.objects);
  EXPECT_LE(largest_difference(in_order.image, render(row, scene).image),
            row.promises.order_spread);
  EXPECT_EQ(in_order.stats.total_bytes(), 16u * 5 * 4);  // bytes_per_pixel
}

TEST(UnitToyMethod, WrongOptionsAreRefused) {
  const scene::MethodRow row = find_row("method", "color-filter", rows());
  EXPECT_THROW(render(row, stack(2, 2, {Rgba(1)}), {{"strength", "2"}}), InputError);
  EXPECT_THROW(render(row, stack(2, 2, {Rgba(1)}), {{"stength", "1"}}), InputError);
}

}  // namespace
}  // namespace pellucid::oit
