// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace pellucid::compare {

/// FLIP's filters of colours reach so many pixels to each side: at 67 pixels per degree 3 σ of the
/// widest Gaussian of the contrast sensitivity, rounded up.
constexpr int color_radius = 10;
/// FLIP's detectors of features reach so many pixels: 3 σ of theirs, rounded up.
constexpr int feature_radius = 9;

/// w[k] weighs the taps at +k and, with the filter's symmetry, at -k.
template <int radius>
using Taps = std::array<float, radius + 1>;
/// Taps of a filter of colours.
using ColorTaps = Taps<color_radius>;
/// Taps of a detector of features.
using FeatureTaps = Taps<feature_radius>;

/// FlipFilters are the rows, and columns, of FLIP's filters: of y, x - y and y - z (OpponentColor),
/// where the last is a weighted sum of two; and a Gaussian with its first derivative, which is odd,
/// and its second.
struct FlipFilters {
  ColorTaps y, xy, yz[2];
  float yz_weight[2];
  FeatureTaps smooth, edge, point;
};

/// Computes them in double.
FlipFilters make_flip_filters();

}  // namespace pellucid::compare
