// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "scene/appearance/colormap.h"

namespace pellucid::scene {

/// A ColorSpace is one in which a map's stops are joined by straight lines, under ParaView's name.
struct ColorSpace {
  std::string_view name;
  Vec3 (*between)(const Vec3& a, const Vec3& b, double fraction);  // of sRGB, in [0, 1]
};

/// Returns the table of colour spaces: RGB, Lab, Diverging.
std::span<const ColorSpace> color_spaces();

/// Returns stops that are linear in RGB between them, and follow those of the space: some more in
/// each interval, unless it is RGB itself.
std::vector<ColorStop> linear_in_rgb(const std::vector<ColorStop>& stops, const ColorSpace& space);

}  // namespace pellucid::scene
