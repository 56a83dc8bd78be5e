// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "core/vec.h"

namespace pellucid::scene {

/// A Lighting says how fragments are lit: by a light at the eye, alike from both sides, so that
/// c = |n · v| is all there is of the place of the light.
enum class Lighting {
  none,       // a fragment has the interpolated colour of its vertices
  headlight,  // times c: diffuse
  phong       // with ambient light and a white highlight beside it
};

/// The lightings' names in scene files, in the order of Lighting.
inline constexpr std::array<std::string_view, 3> lighting_names{"none", "headlight", "phong"};

/// Returns its name in scene files.
inline std::string_view name_of(Lighting lighting) { return lighting_names[std::size_t(lighting)]; }

/// Returns the colour in the light, in [0, 1] as `color` is. Phong: Illumination for Computer
/// Generated Pictures, CACM 18 (1975): the reflected ray is twice as far from the eye as the
/// normal, its cosine is 2 c² - 1. oit/shapes/lighting.glsl says the same.
inline Vec3 lit(Lighting lighting, const Vec3& color, double c) {
  constexpr double ambient = 0.15, highlight = 0.35;
  constexpr double exponent = 24;
  if (lighting == Lighting::none) return color;
  if (lighting == Lighting::headlight) return color * c;
  const double shine = highlight * std::pow(std::max(0.0, 2 * c * c - 1), exponent);
  return glm::min(color * (ambient + (1 - ambient) * c) + shine, 1.0);
}

}  // namespace pellucid::scene
