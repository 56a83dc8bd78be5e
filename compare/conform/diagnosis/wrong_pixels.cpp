// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/conform/diagnosis/wrong_pixels.h"

namespace pellucid::compare {
namespace {

/// An explanation of a pixel leaves no more than this share of its error.
constexpr double most_left = 0.5;

double difference(const glm::dvec4& a, const Rgba& b) {
  const Vec3 off = glm::abs(Vec3(a) - Vec3(b));
  return std::max({off.r, off.g, off.b});
}

}  // namespace

WrongPixels::WrongPixels(const ConformanceCase& conformance_case, const Image& picture,
                         bool stored_in_8_bits, double tolerance)
    : case_(conformance_case),
      picture_(picture),
      stored_in_8_bits_(stored_in_8_bits),
      tolerance_(tolerance + (stored_in_8_bits ? half_step : 0)) {
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    errors_.push_back(difference(composite_of(layers(i), behind()), shown(i)));
    max_error_ = std::max(max_error_, errors_.back());
    if (errors_.back() > tolerance_) wrong_.push_back(i);
  }
}

bool WrongPixels::is(std::size_t pixel, const glm::dvec4& color, double tolerance) const {
  return difference(color, shown(pixel)) <= std::min(tolerance, most_left * error(pixel));
}

bool WrongPixels::is_composite(const Composite& composite, double tolerance) const {
  return explains([&](std::size_t i) { return is(i, composite(layers(i), behind()), tolerance); });
}

}  // namespace pellucid::compare
