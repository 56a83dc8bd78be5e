// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compare/conform/diagnosis/wrong_pixels.h"

namespace pellucid::compare {

/// An Explanation says what a wrong picture looks like, a kind of Fault and more for people, and
/// what it leaves of the error of nine tenths of the wrong pixels.
struct Explanation {
  std::string_view fault;
  std::string text;
  double left = 0;
};

/// Explanations are those found so far, in order of preference.
using Explanations = std::vector<Explanation>;

/// Adds an explanation that leaves so much, if it explains anything.
inline void add_explanation(Explanations& found, std::string_view fault, std::string text,
                            const std::optional<double>& left) {
  if (left) found.push_back({fault, std::move(text), *left});
}

// Each looks for one kind, and adds what of it explains the wrong pixels, best first.

/// Tell what the picture's file keeps of numbers, or the renderer did: kept_digits.cpp.
///@{
void of_8_bits(const WrongPixels& pixels, Explanations& found);
void of_half_floats(const WrongPixels& pixels, Explanations& found);
///@}

/// Tell what colours became of the right ones, or of the layers': wrong_colors.cpp.
///@{
void of_other_colors(const WrongPixels& pixels, Explanations& found);
void of_brighter_colors(const WrongPixels& pixels, Explanations& found);
///@}

/// Tell what else is seen: shown_colors.cpp. Of a background that nothing confirms only what errs
/// visibly is said to be one.
///@{
void over_black_or_white(const WrongPixels& pixels, Explanations& found);
void over_another_background(const WrongPixels& pixels, Explanations& found);
void over_an_unconfirmed_background(const WrongPixels& pixels, Explanations& found);
void of_a_turned_picture(const WrongPixels& pixels, Explanations& found);
void of_the_picture(const WrongPixels& pixels, Explanations& found);
///@}

/// Tell which layers count, and how much: counted_layers.cpp. Those of all pixels alike, then those
/// of which each pixel may have lost, or have, another one.
///@{
void without_any(const WrongPixels& pixels, Explanations& found);
void let_through(const WrongPixels& pixels, Explanations& found);
void clamped(const WrongPixels& pixels, Explanations& found);
void capped(const WrongPixels& pixels, Explanations& found);
void missed(const WrongPixels& pixels, Explanations& found);
void doubled(const WrongPixels& pixels, Explanations& found);
void counted_otherwise(const WrongPixels& pixels, Explanations& found);
///@}

/// Tell in which order they do: ordered_layers.cpp. The first knows the order, the second tries all
/// of few layers, the third only knows that they are the layers.
///@{
void misordered(const WrongPixels& pixels, Explanations& found);
void permuted(const WrongPixels& pixels, Explanations& found);
void mixed(const WrongPixels& pixels, Explanations& found);
///@}

}  // namespace pellucid::compare
