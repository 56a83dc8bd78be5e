// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "compare/conform/diagnosis/diagnose.h"
#include "compare/conform/diagnosis/explanations.h"

namespace pellucid::compare {
namespace {

/// What a layer of opacity alpha hides when it counts several times, or none.
double opacity_of(double alpha, std::size_t times) {
  return 1 - std::pow(1 - alpha, double(times));
}

/// Cuts are the composites before and behind each layer: a change of one layer takes but these.
struct Cuts {
  std::vector<glm::dvec4> before;  // colour and transmittance of the nearest i layers
  std::vector<Vec3> behind;        // of all but these, over the background

  Vec3 joined(std::size_t i, const Vec3& rest) const {
    return Vec3(before[i]) + before[i].a * rest;
  }
};

Cuts cuts_of(const Layers& all, const Vec3& background) {
  Cuts cuts{{glm::dvec4(0, 0, 0, 1)}, std::vector<Vec3>(all.size() + 1, background)};
  for (const Rgba& layer : all) {
    const glm::dvec4& sum = cuts.before.back();
    const double alpha = double(layer.a);
    cuts.before.emplace_back(Vec3(sum) + sum.a * alpha * Vec3(layer), sum.a * (1 - alpha));
  }
  for (std::size_t i = all.size(); i-- > 0;)
    cuts.behind[i] = glm::mix(cuts.behind[i + 1], Vec3(all[i]), double(all[i].a));
  return cuts;
}

/// As it is when one of the layers counts so often.
void add_with_count(const Layers& all, const Cuts& cuts, std::size_t times,
                    std::vector<Vec3>& colors) {
  for (std::size_t i = 0; i < all.size(); ++i)
    colors.push_back(cuts.joined(
        i, glm::mix(cuts.behind[i + 1], Vec3(all[i]), opacity_of(double(all[i].a), times))));
}

/// An edge or vertex is often met once for each triangle that it belongs to; of many layers more
/// than twice is not looked for.
std::vector<Vec3> with_one_again(const Layers& all, const Vec3& background) {
  constexpr std::size_t most_times = 6, few = 20;
  const Cuts cuts = cuts_of(all, background);
  std::vector<Vec3> colors;
  for (std::size_t times = 2; times <= (all.size() <= few ? most_times : 2); ++times)
    add_with_count(all, cuts, times, colors);
  return colors;
}

std::vector<Vec3> without_one(const Layers& all, const Vec3& background) {
  std::vector<Vec3> colors;
  add_with_count(all, cuts_of(all, background), 0, colors);
  return colors;
}

/// Of those that equal layer i that one alone.
Layers with_one_of_equals(const Layers& all, std::size_t i) {
  Layers left;
  for (std::size_t k = 0; k < all.size(); ++k)
    if (k == i || all[k] != all[i]) left.push_back(all[k]);
  return left;
}

/// Of more layers equal ones are not looked for.
std::vector<Vec3> without_equals(const Layers& all, const Vec3& background) {
  constexpr std::size_t few = 300;
  std::vector<Vec3> colors;
  for (std::size_t i = 0; i < all.size() && all.size() <= few; ++i)
    if (const Layers left = with_one_of_equals(all, i); left.size() < all.size())
      colors.emplace_back(composite_of(left, background));
  return colors;
}

/// As it is when each of the layers counts from `least` to `most` times, in all ways.
std::vector<Vec3> with_counts(const Layers& all, const Vec3& background, std::size_t least,
                              std::size_t most) {
  std::vector<Vec3> colors{background};
  for (auto layer = all.rbegin(); layer != all.rend(); ++layer) {
    std::vector<Vec3> before;
    for (std::size_t times = least; times <= most; ++times)
      for (const Vec3& behind : colors)
        before.push_back(glm::mix(behind, Vec3(*layer), opacity_of(double(layer->a), times)));
    colors = std::move(before);
  }
  return colors;
}

/// Of so many layers at most; of others there are none.
WrongPixels::Colors all_counts(const WrongPixels& pixels, std::size_t few, std::size_t least,
                               std::size_t most) {
  return [&pixels, few, least, most](const Layers& all) {
    return all.size() <= few ? with_counts(all, pixels.behind(), least, most) : std::vector<Vec3>();
  };
}

/// The nearest or the farthest k of the layers, over the background.
Vec3 some(const Cuts& cuts, std::size_t k, bool nearest, const Vec3& background) {
  const std::size_t count = cuts.behind.size() - 1, kept = std::min(k, count);
  return nearest ? cuts.joined(kept, background) : cuts.behind[count - kept];
}

/// The few k that fit the pixel best.
std::vector<std::size_t> caps_of(const WrongPixels& pixels, std::size_t pixel, const Cuts& cuts,
                                 bool nearest) {
  constexpr std::size_t most_tried = 8;
  std::vector<std::pair<double, std::size_t>> fits;
  for (std::size_t k = 1; k + 1 < cuts.behind.size(); ++k)
    fits.emplace_back(pixels.off(pixel, some(cuts, k, nearest, pixels.behind())), k);
  std::ranges::sort(fits);
  std::vector<std::size_t> best;
  for (std::size_t i = 0; i < std::min(fits.size(), most_tried); ++i)
    best.push_back(fits[i].second);
  return best;
}

void capped_from(const WrongPixels& pixels, std::size_t deepest, bool nearest,
                 Explanations& found) {
  const Cuts cuts = cuts_of(pixels.layers(deepest), pixels.behind());
  Explanations caps;
  for (const std::size_t k : caps_of(pixels, deepest, cuts, nearest)) {
    const auto cap = [&](const Layers& all) {
      return std::vector{some(cuts_of(all, pixels.behind()), k, nearest, pixels.behind())};
    };
    add_explanation(caps, Fault::capped,
                    fmt::format("only the {} {} layers", nearest ? "nearest" : "farthest", k),
                    pixels.left_by_nearest(cap));
  }
  std::ranges::stable_sort(caps, {}, &Explanation::left);
  found.insert(found.end(), caps.begin(), caps.end());
}

}  // namespace

void without_any(const WrongPixels& pixels, Explanations& found) {
  add_explanation(
      found, Fault::missed, "all layers are missing",
      pixels.left_by_nearest([&](const Layers&) { return std::vector<Vec3>{pixels.behind()}; }));
}

void let_through(const WrongPixels& pixels, Explanations& found) {
  const auto ignored = [&](const Layers& layers, const Vec3& background) {
    return composite_of(as_drawn(pixels.conformance_case(), layers), background);
  };
  add_explanation(found, Fault::opaque, "what is said to be opaque lets through what is behind it",
                  pixels.left_by_composite(ignored, pixels.nearly_all()));
}

void missed(const WrongPixels& pixels, Explanations& found) {
  add_explanation(
      found, Fault::missed, fmt::format("a layer is missing in {} pixels", pixels.wrong().size()),
      pixels.left_by_nearest([&](const Layers& all) { return without_one(all, pixels.behind()); }));
  add_explanation(found, Fault::missed, "of equal layers one is left",
                  pixels.left_by_nearest(
                      [&](const Layers& all) { return without_equals(all, pixels.behind()); }));
}

/// Of two or three layers, the farthest ones alone are said to be those that others miss.
void capped(const WrongPixels& pixels, Explanations& found) {
  const auto depth = [&](std::size_t i) { return pixels.layers(i).size(); };
  const std::size_t deepest = *std::ranges::max_element(pixels.wrong(), {}, depth);
  if (depth(deepest) > 2) capped_from(pixels, deepest, true, found);
  if (depth(deepest) > 3) capped_from(pixels, deepest, false, found);
}

void doubled(const WrongPixels& pixels, Explanations& found) {
  const std::size_t count = pixels.wrong().size();
  const auto again = [&](const Layers& all) { return with_one_again(all, pixels.behind()); };
  const auto again_or_missing = [&](const Layers& all) {
    std::vector<Vec3> colors = again(all);
    const std::vector<Vec3> missing = without_one(all, pixels.behind());
    colors.insert(colors.end(), missing.begin(), missing.end());
    return colors;
  };
  for (const std::size_t times : {2u, 3u, 4u, 5u, 6u})
    add_explanation(found, Fault::doubled, fmt::format("each layer counts {} times", times),
                    pixels.left_by_composite(
                        [times](Layers layers, const Vec3& background) {
                          for (Rgba& layer : layers)
                            layer.a = float(opacity_of(double(layer.a), times));
                          return composite_of(layers, background);
                        },
                        pixels.nearly_all()));
  add_explanation(found, Fault::doubled, fmt::format("a layer counts again in {} pixels", count),
                  pixels.left_by_nearest(again));
  add_explanation(found, Fault::doubled,
                  fmt::format("a layer counts again, or is missing, in {} pixels", count),
                  pixels.left_by_nearest(again_or_missing));
}

void counted_otherwise(const WrongPixels& pixels, Explanations& found) {
  constexpr std::size_t for_subsets = 8, for_counts = 3, most_times = 8;
  const std::size_t count = pixels.wrong().size();
  add_explanation(found, Fault::missed, fmt::format("layers are missing in {} pixels", count),
                  pixels.left_by_nearest(all_counts(pixels, for_subsets, 0, 1)));
  add_explanation(found, Fault::doubled, fmt::format("layers count again in {} pixels", count),
                  pixels.left_by_nearest(all_counts(pixels, for_counts, 1, most_times)));
  add_explanation(found, Fault::doubled,
                  fmt::format("layers count again, or are missing, in {} pixels", count),
                  pixels.left_by_nearest(all_counts(pixels, for_counts, 0, most_times)));
}

void clamped(const WrongPixels& pixels, Explanations& found) {
  for (const float most : {0.99f, 0.995f, 254.f / 255, 0.999f, 0.9999f}) {
    const auto composite = [most](Layers layers, const Vec3& background) {
      for (Rgba& layer : layers) layer.a = std::min(layer.a, most);
      return composite_of(layers, background);
    };
    add_explanation(found, Fault::other, fmt::format("opacities end at {:.4g}", most),
                    pixels.left_by_composite(composite, pixels.nearly_all()));
  }
}

}  // namespace pellucid::compare
