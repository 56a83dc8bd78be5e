// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/pictures/flip_filters.h"

#include <cassert>
#include <cmath>
#include <numbers>

namespace pellucid::compare {
namespace {

/// 0.7 m from a display of 0.7 m and 3840 pixels.
constexpr double pixels_per_degree = 0.7 * 3840 / 0.7 * std::numbers::pi / 180;

/// The contrast sensitivity a₁ √(π/b₁) exp(-π² r²/b₁) + a₂ … of r in degrees.
struct Gaussian {
  double a, b;

  double at(int pixels) const {
    const double r = pixels / pixels_per_degree;
    return std::exp(-std::numbers::pi * std::numbers::pi * r * r / b);
  }
  double row_sum() const {
    double sum = at(0);
    for (int k = 1; k <= color_radius; ++k) sum += 2 * at(k);
    return sum;
  }
  /// Of the whole square, before it is normalized.
  double weight() const { return a * std::sqrt(std::numbers::pi / b) * row_sum() * row_sum(); }
  ColorTaps taps() const {
    ColorTaps w{};
    for (int k = 0; k <= color_radius; ++k) w[k] = float(at(k) / row_sum());
    return w;
  }
};

constexpr Gaussian achromatic{1, 0.0047}, red_green{1, 0.0053};
constexpr Gaussian blue_yellow[] = {{34.1, 0.04}, {13.5, 0.025}};

/// The derivatives' positive taps add to 1, their negative ones to -1.
void set_features(FlipFilters& filters) {
  const double sd = 0.5 * 0.082 * pixels_per_degree;  // the width of detectors, 0.082°, is 2 σ
  assert(int(std::ceil(3 * sd)) == feature_radius);
  const auto gaussian = [&](int x) { return std::exp(-x * x / (2 * sd * sd)); };
  const auto second = [&](int x) { return (x * x / (sd * sd) - 1) * gaussian(x); };
  double all = gaussian(0), rising = 0, above = 0, below = -second(0);
  for (int x = 1; x <= feature_radius; ++x) {
    all += 2 * gaussian(x);
    rising += x * gaussian(x);
    (second(x) > 0 ? above : below) += 2 * std::abs(second(x));
  }
  for (int x = 0; x <= feature_radius; ++x) {
    filters.smooth[x] = float(gaussian(x) / all);
    filters.edge[x] = float(x * gaussian(x) / rising);
    filters.point[x] = float(second(x) / (second(x) > 0 ? above : below));
  }
}

}  // namespace

FlipFilters make_flip_filters() {
  assert(int(std::ceil(3 * std::sqrt(blue_yellow[0].b / 2) / std::numbers::pi *
                       pixels_per_degree)) == color_radius);
  FlipFilters filters{};
  filters.y = achromatic.taps();
  filters.xy = red_green.taps();
  const double whole = blue_yellow[0].weight() + blue_yellow[1].weight();
  for (int i : {0, 1}) {
    filters.yz[i] = blue_yellow[i].taps();
    filters.yz_weight[i] = float(blue_yellow[i].weight() / whole);
  }
  set_features(filters);
  return filters;
}

}  // namespace pellucid::compare
