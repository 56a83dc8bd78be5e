// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "compare/conform/diagnosis/diagnose.h"
#include "compare/conform/diagnosis/explanations.h"

namespace pellucid::compare {
namespace {

/// Of more layers one more or less is not looked for: it would be a guess among too many.
constexpr std::size_t few_layers = 300;

bool is_of(const WrongPixels& pixels, std::size_t pixel, const Layers& layers) {
  return pixels.is(pixel, composite_of(layers, pixels.behind()), 2 * pixels.tolerance());
}

/// Whether the pixel is that of `changed(layers, i)` for one of its layers i.
template <class Changed>
bool is_with_change(const WrongPixels& pixels, std::size_t pixel, const Changed& changed) {
  const Layers& all = pixels.layers(pixel);
  if (all.size() > few_layers) return false;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Layers layers = changed(all, i);
    if (layers.size() != all.size() && is_of(pixels, pixel, layers)) return true;
  }
  return false;
}

Layers without(Layers all, std::size_t i) {
  all.erase(all.begin() + std::ptrdiff_t(i));
  return all;
}

/// Of those that equal layer i that one alone.
Layers with_one_of_equals(const Layers& all, std::size_t i) {
  Layers left;
  for (std::size_t k = 0; k < all.size(); ++k)
    if (k == i || all[k] != all[i]) left.push_back(all[k]);
  return left;
}

/// Whether it is as if one of the layers, or each, counted up to `most_times`: an edge or vertex
/// is often met once for each triangle that it belongs to.
bool counts_again(const WrongPixels& pixels, std::size_t pixel) {
  constexpr std::size_t most_times = 6, few = 20;
  const Layers& all = pixels.layers(pixel);
  for (std::size_t more = 1; more < (all.size() <= few ? most_times : 2); ++more) {
    const auto again = [more](Layers layers, std::size_t i) {
      layers.insert(layers.begin() + std::ptrdiff_t(i), more, Layers::value_type(layers[i]));
      return layers;
    };
    Layers each;
    for (const Rgba& layer : all) each.insert(each.end(), more + 1, layer);
    if (is_with_change(pixels, pixel, again) || is_of(pixels, pixel, each)) return true;
  }
  return false;
}

/// The nearest or the farthest k of the layers.
Layers some(const Layers& all, std::size_t k, bool nearest) {
  const auto count = std::ptrdiff_t(std::min(k, all.size()));
  return nearest ? Layers(all.begin(), all.begin() + count) : Layers(all.end() - count, all.end());
}

/// Every k for which that is the pixel's colour.
std::vector<std::size_t> caps_of(const WrongPixels& pixels, std::size_t pixel, bool nearest) {
  const Layers& all = pixels.layers(pixel);
  const Vec3& behind = pixels.behind();
  std::vector<std::size_t> fit;
  glm::dvec4 sum = nearest ? glm::dvec4(0) : glm::dvec4(behind, 0);
  for (std::size_t k = 1; k < all.size(); ++k) {
    const Rgba& layer = nearest ? all[k - 1] : all[all.size() - k];
    const double alpha = double(layer.a);
    const glm::dvec4 opaque(Vec3(layer), 1);
    sum = nearest ? sum + (1 - sum.a) * alpha * opaque : glm::mix(sum, opaque, alpha);
    const Vec3 color = nearest ? Vec3(sum) + (1 - sum.a) * behind : Vec3(sum);
    if (pixels.is(pixel, {color, 0}, 2 * pixels.tolerance())) fit.push_back(k);
  }
  return fit;
}

std::optional<Explanation> capped_from(const WrongPixels& pixels, std::size_t deepest,
                                       bool nearest) {
  constexpr std::size_t most_tried = 8;
  std::vector<std::size_t> caps = caps_of(pixels, deepest, nearest);
  caps.resize(std::min(caps.size(), most_tried));
  for (const std::size_t k : caps)
    if (pixels.explains(
            [&](std::size_t i) { return is_of(pixels, i, some(pixels.layers(i), k, nearest)); }))
      return Explanation{Fault::capped,
                         fmt::format("only the {} {} layers", nearest ? "nearest" : "farthest", k)};
  return std::nullopt;
}

}  // namespace

std::optional<Explanation> missed(const WrongPixels& pixels) {
  if (pixels.explains([&](std::size_t i) { return is_of(pixels, i, {}); }))
    return Explanation{Fault::missed, "all layers are missing"};
  if (pixels.explains([&](std::size_t i) { return is_with_change(pixels, i, without); }))
    return Explanation{Fault::missed,
                       fmt::format("a layer is missing in {} pixels", pixels.wrong().size())};
  if (pixels.explains([&](std::size_t i) { return is_with_change(pixels, i, with_one_of_equals); }))
    return Explanation{Fault::missed, "of equal layers one is left"};
  return std::nullopt;
}

std::optional<Explanation> capped(const WrongPixels& pixels) {
  const auto depth = [&](std::size_t i) { return pixels.layers(i).size(); };
  const std::size_t deepest = *std::ranges::max_element(pixels.wrong(), {}, depth);
  if (depth(deepest) <= 2) return std::nullopt;
  for (const bool nearest : {true, false})
    if (auto found = capped_from(pixels, deepest, nearest)) return found;
  return std::nullopt;
}

std::optional<Explanation> doubled(const WrongPixels& pixels) {
  const std::vector<std::size_t>& wrong = pixels.wrong();
  const auto again = [&](std::size_t i) { return counts_again(pixels, i); };
  const auto missing = [&](std::size_t i) { return is_with_change(pixels, i, without); };
  if (pixels.explains(again))
    return Explanation{Fault::doubled,
                       fmt::format("a layer counts again in {} pixels", wrong.size())};
  if (!pixels.explains([&](std::size_t i) { return again(i) || missing(i); })) return std::nullopt;
  const auto missed = std::size_t(std::ranges::count_if(wrong, missing));
  return Explanation{Fault::doubled,
                     fmt::format("a layer counts again in {} pixels, and is missing in {}",
                                 wrong.size() - missed, missed)};
}

std::optional<Explanation> clamped(const WrongPixels& pixels) {
  for (const float most : {0.99f, 0.995f, 254.f / 255, 0.999f, 0.9999f}) {
    const auto is_clamped = [&](std::size_t i) {
      Layers layers = pixels.layers(i);
      for (Rgba& layer : layers) layer.a = std::min(layer.a, most);
      return is_of(pixels, i, layers);
    };
    if (pixels.explains(is_clamped))
      return Explanation{Fault::other, fmt::format("opacities end at {:.4g}", most)};
  }
  return std::nullopt;
}

}  // namespace pellucid::compare
