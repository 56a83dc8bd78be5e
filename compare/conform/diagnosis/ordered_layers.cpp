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
bool is_permuted(const WrongPixels& pixels, std::size_t pixel) {
  constexpr std::size_t few = 6;
  const Layers& all = pixels.layers(pixel);
  if (all.size() > few) return false;
  std::vector<std::size_t> order(all.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  while (std::ranges::next_permutation(order).found) {
    Layers permuted;
    for (const std::size_t i : order) permuted.push_back(all[i]);
    if (pixels.is(pixel, composite_of(permuted, pixels.behind()), 2 * pixels.tolerance()))
      return true;
  }
  return false;
}

/// Every order of layers, and their mean, leaves the same of the background: between the darkest
/// and the brightest layer over it a colour is one of layers that are there.
bool is_mixed(const WrongPixels& pixels, std::size_t pixel) {
  const Layers& all = pixels.layers(pixel);
  if (all.size() < 2 || pixels.error(pixel) <= least_seen) return false;
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

std::optional<Explanation> misordered(const WrongPixels& pixels) {
  const struct {
    WrongPixels::Composite composite;
    const char* what;
  } ways[] = {{backwards, "the farthest layer is taken for the nearest"},
              {averaged, "no order: the mean colour of all layers"},
              {averaged_with_opacity, "no order: mean colour and mean opacity of all layers"},
              {summed, "no order: the sum of all layers"}};
  for (const auto& [composite, what] : ways)
    if (pixels.is_composite(composite, 2 * pixels.tolerance()))
      return Explanation{Fault::misordered, what};
  if (pixels.explains([&](std::size_t i) { return is_permuted(pixels, i); }))
    return Explanation{Fault::misordered, "layers in another order"};
  if (pixels.explains([&](std::size_t i) { return is_mixed(pixels, i); }))
    return Explanation{Fault::misordered, "all layers, in another order or in none"};
  return std::nullopt;
}

}  // namespace pellucid::compare
