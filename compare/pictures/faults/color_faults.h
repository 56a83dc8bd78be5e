// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>
#include <span>

#include "core/raster.h"

namespace pellucid::compare {

/// As far as 8-bit rounding of a picture and of the background may be apart.
constexpr double same_color = 1.5 / 255;

/// Returns the largest of red, green and blue.
inline double largest(const Vec3& color) { return std::max({color.r, color.g, color.b}); }

/// A Truth is what a picture is held against: the right one, and what is behind it.
struct Truth {
  const Image& reference;
  Vec3 background;
};

/// A ColorFault is what may have happened to colours, and how it is undone.
struct ColorFault {
  const char* name;  // empty: none, or another background, which is told by its colour
  Image (*undone)(const Image& image, const Truth& truth);
  /// How far the background may be off when it is undone. A curve is often a power of 2.2, which is
  /// off sRGB's by up to 0.03.
  double background_apart = same_color;
};

/// All of them, that which changes nothing first.
std::span<const ColorFault> color_faults();

/// Says whether the fault is that another background is behind the colours.
bool is_background(const ColorFault& color);

/// Returns the picture, whose colours are straight, multiplied by its A and over the background.
Image multiplied_over_background(const Image& image, const Truth& truth);

/// Returns the median colour of the test where the reference has no layer; nothing where that is
/// too little to tell. Both have one size.
std::optional<Vec3> color_of_uncovered(const Image& reference, const Image& test);

/// Returns what is behind a test's colours, as its uncovered pixels show it or, where it has none,
/// what shows through all; nothing where neither can tell.
std::optional<Vec3> color_behind(const Truth& truth, const Image& test);

}  // namespace pellucid::compare
