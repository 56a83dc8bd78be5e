// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/vec.h"

namespace pellucid::scene {

/// This is the colour of NaN in every map: VTK's, a dark red that no map has.
inline const Vec3 nan_color(0.5, 0, 0);

/// Returns (value - low) / (high - low), which does not overflow where these numbers do not; low
/// may not be high.
double fraction_between(double value, double low, double high);

/// A ColormapRow is a named colour map: colours at even distances, interpolated linearly.
struct ColormapRow {
  std::string_view name;
  std::string_view citation;
  const std::uint8_t (*table)[3];
  int count = 256;    // of colours
  double unit = 255;  // a channel's 1 in the table

  /// Returns the colour at x, which is clamped to [0, 1]; nan_color for NaN.
  Vec3 operator()(double x) const;
};

/// A ColorStop is the colour at one place of a map.
struct ColorStop {
  double at = 0;
  Vec3 color{0};  // red, green, blue in [0, 1]
};

/// A Colormap is a map of one's own: colours at places that ascend, interpolated linearly between
/// them.
class Colormap {
 public:
  /// Takes two stops or more. Throws InputError when their places do not ascend.
  explicit Colormap(std::vector<ColorStop> stops);

  /// Returns the colour at the fraction x of the way from the first stop to the last, which is
  /// clamped to [0, 1]; nan_color for NaN.
  Vec3 operator()(double x) const;
  /// Returns the first and the last place.
  Vec2 ends() const { return {stops_.front().at, stops_.back().at}; }
  std::span<const ColorStop> stops() const { return stops_; }

 private:
  std::vector<ColorStop> stops_;
};

/// Returns the table of colour maps.
std::span<const ColormapRow> colormaps();

/// Returns the colour map of that name. Throws InputError with the nearest names when there is
/// none.
const ColormapRow& find_colormap(std::string_view name);

}  // namespace pellucid::scene
