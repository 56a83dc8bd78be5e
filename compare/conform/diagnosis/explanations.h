// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "compare/conform/diagnosis/wrong_pixels.h"

namespace pellucid::compare {

/// An Explanation says what a wrong picture looks like: a kind of Fault, and more for people.
struct Explanation {
  std::string_view fault;
  std::string text;
};

// Each looks for one kind, and returns nothing where that does not explain the wrong pixels.

/// Tell what the picture's file keeps of numbers, or the renderer did: kept_digits.cpp.
///@{
std::optional<Explanation> nearly_right(const WrongPixels& pixels);
std::optional<Explanation> of_8_bits(const WrongPixels& pixels);
std::optional<Explanation> of_half_floats(const WrongPixels& pixels);
///@}

/// Tell what else is seen: shown_colors.cpp.
///@{
std::optional<Explanation> over_another_background(const WrongPixels& pixels);
std::optional<Explanation> through_a_curve(const WrongPixels& pixels);
std::optional<Explanation> of_the_picture(const WrongPixels& pixels);
///@}

/// Tell which layers count, and how much: counted_layers.cpp.
///@{
std::optional<Explanation> missed(const WrongPixels& pixels);
std::optional<Explanation> capped(const WrongPixels& pixels);
std::optional<Explanation> doubled(const WrongPixels& pixels);
std::optional<Explanation> clamped(const WrongPixels& pixels);
///@}

/// Tells in which order they do: ordered_layers.cpp.
std::optional<Explanation> misordered(const WrongPixels& pixels);

}  // namespace pellucid::compare
