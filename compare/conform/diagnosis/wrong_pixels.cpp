// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/conform/diagnosis/wrong_pixels.h"

#include <glm/gtc/packing.hpp>
#include <limits>

namespace pellucid::compare {
namespace {

/// An explanation of a pixel leaves no more than this share of its error.
constexpr double most_left = 0.5;
/// What compositing in floats loses in hundreds of layers.
constexpr double float_rounding = 1e-5;

double largest(const Vec3& v) { return std::max({v.r, v.g, v.b}); }

bool is_of_half_floats(const Image& picture) {
  return std::ranges::all_of(picture.pixels, [](const Rgba& p) {
    return Vec3(p) == Vec3(glm::unpackHalf1x16(glm::packHalf1x16(p.r)),
                           glm::unpackHalf1x16(glm::packHalf1x16(p.g)),
                           glm::unpackHalf1x16(glm::packHalf1x16(p.b)));
  });
}

double rounding_of(const Image& picture, bool stored_in_8_bits) {
  if (stored_in_8_bits) return half_step;
  return is_of_half_floats(picture) ? half_float_step : float_rounding;
}

}  // namespace

WrongPixels::WrongPixels(const ConformanceCase& conformance_case, const Image& picture,
                         bool stored_in_8_bits, double tolerance)
    : case_(conformance_case),
      picture_(picture),
      stored_in_8_bits_(stored_in_8_bits),
      tolerance_(tolerance + (stored_in_8_bits ? half_step : 0)),
      rounding_(rounding_of(picture, stored_in_8_bits)) {
  const Image right = expected_picture(case_);
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    errors_.push_back(largest(glm::abs(Vec3(right.pixels[i]) - Vec3(shown(i)))));
    max_error_ = std::max(max_error_, errors_.back());
    if (errors_.back() > tolerance_) wrong_.push_back(i);
  }
}

double WrongPixels::off(std::size_t pixel, const Vec3& color) const {
  const Vec3 seen = stored_in_8_bits_ ? glm::clamp(color, Vec3(0), Vec3(1)) : color;
  return largest(glm::abs(seen - Vec3(shown(pixel))));
}

std::optional<double> WrongPixels::left_by(const LeftOf& left_of, double most) const {
  std::vector<double> left;
  std::size_t failed = 0;
  for (const std::size_t i : wrong_) {
    left.push_back(left_of(i));
    if (!(left.back() <= std::min(most, most_left * error(i))) && ++failed > may_fail())
      return std::nullopt;
  }
  const auto quantile = left.end() - 1 - std::ptrdiff_t(may_fail());
  std::nth_element(left.begin(), quantile, left.end());
  return *quantile;
}

std::optional<double> WrongPixels::left_by_nearest(const Colors& colors) const {
  std::vector<std::optional<std::vector<Vec3>>> known(case_.layers.size());
  const auto left_of = [&](std::size_t i) {
    auto& of_layers = known[std::size_t(case_.which.pixels[i])];
    if (!of_layers) of_layers = colors(layers(i));
    double least = std::numeric_limits<double>::infinity();
    for (const Vec3& color : *of_layers) least = std::min(least, off(i, color));
    return least;
  };
  return left_by(left_of, nearly_all());
}

std::optional<double> WrongPixels::left_by_all(const LeftOf& left_of, double most) const {
  const std::optional<double> left = left_by(left_of, most);
  if (!left) return std::nullopt;
  std::size_t spoiled = 0;
  for (std::size_t i = 0; i < errors_.size(); ++i)
    spoiled += errors_[i] <= tolerance_ && left_of(i) > most + tolerance_;
  return spoiled <= may_fail() ? left : std::nullopt;
}

std::optional<double> WrongPixels::left_by_composite(const Composite& composite,
                                                     double most) const {
  std::vector<std::optional<Vec3>> known(case_.layers.size());
  const auto left_of = [&](std::size_t i) {
    auto& color = known[std::size_t(case_.which.pixels[i])];
    if (!color) color = Vec3(composite(layers(i), behind()));
    return off(i, *color);
  };
  return left_by_all(left_of, most);
}

}  // namespace pellucid::compare
