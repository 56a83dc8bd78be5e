// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/conform/diagnosis/diagnose.h"
#include "compare/conform/diagnosis/explanations.h"
#include "compare/conform/diagnosis/wrong_composites.h"

namespace pellucid::compare {
namespace {

glm::dvec4 backwards(const Layers& all, const Vec3& background) {
  return composite_of(Layers(all.rbegin(), all.rend()), background);
}

/// Of a few layers any other order is tried.
std::vector<Vec3> orders_of(const Layers& all, const Vec3& background) {
  constexpr std::size_t few = 6;
  std::vector<Vec3> colors;
  std::vector<std::size_t> order(all.size() <= few ? all.size() : 0);
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  while (std::ranges::next_permutation(order).found) {
    Layers permuted;
    for (const std::size_t i : order) permuted.push_back(all[i]);
    colors.emplace_back(composite_of(permuted, background));
  }
  return colors;
}

/// Every order of layers, and their mean, leaves the same of the background: between the darkest
/// and the brightest layer over it a colour is one of layers that are there.
bool is_mixed(const WrongPixels& pixels, std::size_t pixel) {
  const Layers& all = pixels.layers(pixel);
  if (all.size() < 2 || pixels.max_error() <= least_seen) return false;
  const double left = 1 - composite_of(all, pixels.behind()).a;
  Vec3 low(1), high(0);
  for (const Rgba& layer : all) {
    low = glm::min(low, Vec3(layer));
    high = glm::max(high, Vec3(layer));
  }
  const Vec3 color = Vec3(pixels.shown(pixel)) - left * pixels.behind();
  return glm::all(glm::greaterThanEqual(color, (1 - left) * low - pixels.tolerance())) &&
         glm::all(glm::lessThanEqual(color, (1 - left) * high + pixels.tolerance()));
}

}  // namespace

void misordered(const WrongPixels& pixels, Explanations& found) {
  const struct {
    WrongPixels::Composite composite;
    const char* what;
  } ways[] = {{backwards, "the farthest layer is taken for the nearest"},
              {averaged, "no order: the mean colour of all layers"},
              {averaged_with_opacity, "no order: mean colour and mean opacity of all layers"},
              {summed, "no order: the sum of all layers"}};
  for (const auto& way : ways) {
    const auto drawn = [&](const Layers& all, const Vec3& background) {
      return way.composite(as_drawn(pixels.conformance_case(), all), background);
    };
    for (const WrongPixels::Composite& composite : {way.composite, WrongPixels::Composite(drawn)})
      add_explanation(found, Fault::misordered, way.what,
                      pixels.left_by_composite(composite, pixels.nearly_all()));
  }
}

void permuted(const WrongPixels& pixels, Explanations& found) {
  add_explanation(
      found, Fault::misordered, "layers in another order",
      pixels.left_by_nearest([&](const Layers& all) { return orders_of(all, pixels.behind()); }));
}

void mixed(const WrongPixels& pixels, Explanations& found) {
  const auto left_of = [&](std::size_t i) { return is_mixed(pixels, i) ? 0 : pixels.error(i); };
  add_explanation(found, Fault::misordered, "all layers, in another order or in none",
                  pixels.left_by(left_of, pixels.nearly_all()));
}

}  // namespace pellucid::compare
