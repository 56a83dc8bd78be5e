// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/conform/conformance_case.h"

namespace pellucid::compare {

// What renderers make of layers that composite them in wrong ways. Layers come nearest first; of
// what is returned the colour counts, over the background.

/// A Halfway says which way a renderer rounds to 8 bits what lies between two steps, up to a
/// float's rounding, as 0.1, 0.3, 0.5 and 0.9 do: always down, always up, or by what the float is.
enum class Halfway { down, up, nearest };

/// Blends in a frame buffer of 8 bits, the farthest layer first.
glm::dvec4 blended_in_8_bits(const Layers& layers, const Vec3& background, Halfway halfway);

/// Sums up colour and opacity in 8 bits, the nearest layer first.
glm::dvec4 accumulated_in_8_bits(const Layers& layers, const Vec3& background, Halfway halfway);

/// Keeps fragments in 8 bits, and composites them without rounding.
glm::dvec4 stored_in_8_bits(Layers layers, const Vec3& background, Halfway halfway);

/// Keeps opacities in 8 bits, and composites without rounding.
glm::dvec4 opacities_in_8_bits(Layers layers, const Vec3& background, Halfway halfway);

/// Blends in a frame buffer of half floats, the farthest layer first.
glm::dvec4 blended_in_halves(const Layers& layers, const Vec3& background);

/// Keeps fragments in half floats, and composites them without rounding.
glm::dvec4 stored_in_halves(Layers layers, const Vec3& background);

/// Rounds the right colour to half floats.
glm::dvec4 rounded_to_halves(const Layers& layers, const Vec3& background);

/// Multiplies colours by their opacities before it blends them, which does so again.
glm::dvec4 multiplied_again(Layers layers, const Vec3& background);

/// Blends the right picture over its background again, by its opacity.
glm::dvec4 blended_again(const Layers& layers, const Vec3& background);

/// Blends colours as if they were multiplied by their opacities, which they are not.
glm::dvec4 not_multiplied(const Layers& layers, const Vec3& background);

/// Leaves straight colours, neither multiplied by A nor over the background.
glm::dvec4 straight(const Layers& layers, const Vec3& background);

/// Takes the mean colour, weighted by opacity, under the layers' transmittance.
glm::dvec4 averaged(const Layers& layers, const Vec3& background);

/// Takes the mean colour and the mean opacity, n times (Bavoil, Myers 2008).
glm::dvec4 averaged_with_opacity(const Layers& layers, const Vec3& background);

/// Adds the colours, and the background by what one minus all opacities leaves (Meshkin 2007).
glm::dvec4 summed(const Layers& layers, const Vec3& background);

}  // namespace pellucid::compare
