// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/pictures/faults/color_faults.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "compare/pictures/srgb.h"

namespace pellucid::compare {
namespace {

template <class Function>
Image each_pixel(Image image, const Function& function) {
  for (Rgba& pixel : image.pixels) pixel = function(pixel);
  return image;
}

template <class Function>
Image each_channel(const Image& image, const Function& function) {
  return each_pixel(
      image, [&](const Rgba& p) { return Rgba(function(p.r), function(p.g), function(p.b), p.a); });
}

Image over_background(const Image& image, const Truth& truth) {
  return each_pixel(image, [&](const Rgba& p) {
    return p + Rgba(truth.background, 0) * (1 - std::clamp(p.a, 0.f, 1.f));
  });
}

/// The colour that stands behind everything, by least squares of what is off by the reference's
/// 1 - A; nothing where nothing shows through, or where it would be no colour.
std::optional<Vec3> color_behind_all(const Truth& truth, const Image& test) {
  constexpr double least = 1e-3;   // of (1 - A)², in the mean
  constexpr double beyond = 0.02;  // black and white, by the error of the estimate
  Vec3 sum(0);
  double squares = 0;
  for (std::size_t i = 0; i < test.pixels.size(); ++i) {
    const Rgba& wanted = truth.reference.pixels[i];
    const double left = 1 - double(wanted.a);
    sum += left * (Vec3(test.pixels[i]) - Vec3(wanted));
    squares += left * left;
  }
  if (!(squares > least * double(test.pixels.size()))) return std::nullopt;
  const Vec3 color = truth.background + sum / squares;
  const Vec3 possible = glm::clamp(color, Vec3(0), Vec3(1));
  if (largest(glm::abs(color - possible)) > beyond) return std::nullopt;
  return possible;
}

/// By the reference's opacity where the picture has none of its own.
Image on_its_background(const Image& image, const Truth& truth) {
  Image result = image;
  const auto color = color_behind(truth, image);
  const bool has_own = std::ranges::any_of(image.pixels, [](const Rgba& p) { return p.a < 1; });
  const Image& opacity = has_own ? image : truth.reference;
  for (std::size_t i = 0; color && i < image.pixels.size(); ++i)
    result.pixels[i] += Rgba(truth.background - *color, 0) * (1 - opacity.pixels[i].a);
  return result;
}

constexpr double curves_apart = 0.04;

constexpr ColorFault rows[] = {
    {"", [](const Image& image, const Truth&) { return image; }},
    {"looks premultiplied: colour without the background", over_background},
    {"", on_its_background},  // its colour is told below
    {"looks like straight alpha: colour neither multiplied nor over the background",
     multiplied_over_background},
    {"looks sRGB-encoded once too often: linear values were taken for the scene's display values",
     [](const Image& image, const Truth&) { return each_channel(image, decoded_from_srgb<float>); },
     curves_apart},
    {"looks sRGB-decoded: linear values in the place of display values",
     [](const Image& image, const Truth&) { return each_channel(image, encoded_as_srgb<float>); },
     curves_apart},
    {"looks 255 times too bright: values of 0 to 255 in the place of 0 to 1",
     [](const Image& image, const Truth&) {
       return each_channel(image, [](float x) { return x / 255; });
     }},
    {"looks half as bright: every colour is multiplied by 0.5",
     [](const Image& image, const Truth&) {
       return each_channel(image, [](float x) { return 2 * x; });
     }},
    {"looks to have red and blue exchanged: BGR in the place of RGB",
     [](const Image& image, const Truth&) {
       return each_pixel(image, [](const Rgba& p) { return Rgba(p.b, p.g, p.r, p.a); });
     }}};

}  // namespace

std::optional<Vec3> color_of_uncovered(const Image& reference, const Image& test) {
  constexpr std::size_t least = 16;
  std::array<std::vector<float>, 3> channels;
  for (std::size_t i = 0; i < test.pixels.size(); ++i)
    for (int c = 0; c < 3 && reference.pixels[i].a == 0; ++c)
      channels[std::size_t(c)].push_back(test.pixels[i][c]);
  if (channels[0].size() < least) return std::nullopt;
  Vec3 median;
  for (int c = 0; c < 3; ++c) {
    std::vector<float>& values = channels[std::size_t(c)];
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    median[c] = *middle;
  }
  return median;
}

std::optional<Vec3> color_behind(const Truth& truth, const Image& test) {
  const std::optional<Vec3> seen = color_of_uncovered(truth.reference, test);
  return seen ? seen : color_behind_all(truth, test);
}

Image multiplied_over_background(const Image& image, const Truth& truth) {
  return each_pixel(image, [&](const Rgba& p) {
    return Rgba(Vec3(p) * double(p.a) + truth.background * double(1 - p.a), p.a);
  });
}

std::span<const ColorFault> color_faults() { return rows; }

bool is_background(const ColorFault& color) { return color.undone == on_its_background; }

}  // namespace pellucid::compare
