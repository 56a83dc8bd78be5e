// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "core/vec.h"

namespace pellucid::scene {

/// A TextColor is what a text says of a colour.
struct TextColor {
  Vec3 rgb;                     // red, green, blue in [0, 1]
  std::optional<double> alpha;  // in [0, 1], where the text has one
};

/// Returns the colour that CSS writes so: "#rrggbb", "#rgb", both also with two digits or one of
/// opacity, or one of its 148 names, in capital or small letters. Throws InputError for any other
/// text, which names the nearest colours.
TextColor color_of_text(std::string_view text);

/// Returns such a colour that has no opacity. Throws InputError for one that has, too.
Vec3 rgb_of_text(std::string_view text);

}  // namespace pellucid::scene
