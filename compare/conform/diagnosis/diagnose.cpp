// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/conform/diagnosis/diagnose.h"

#include <fmt/format.h>

#include "compare/conform/diagnosis/explanations.h"

namespace pellucid::compare {
namespace {

using Kind = void (*)(const WrongPixels&, Explanations&);

/// What can be held against every pixel. Of those that leave about as little the first is named:
/// what takes the least for granted, and has the least to choose by, comes first.
constexpr Kind exact_kinds[] = {over_black_or_white,
                                of_other_colors,
                                of_half_floats,
                                of_8_bits,
                                without_any,
                                let_through,
                                clamped,
                                misordered,
                                of_a_turned_picture,
                                of_brighter_colors,
                                over_another_background,
                                missed,
                                capped,
                                doubled,
                                permuted,
                                counted_otherwise};

/// What fits too much to be told from what it leaves: in this order, and only where nothing does
/// that can be.
constexpr Kind vague_kinds[] = {over_an_unconfirmed_background, of_the_picture, mixed};

/// As little as the best one leaves is this many times as much, or what rounding does.
constexpr double about = 4;

std::optional<Explanation> best_of(const Explanations& found, double rounding) {
  if (found.empty()) return std::nullopt;
  const double least = std::ranges::min_element(found, {}, &Explanation::left)->left;
  return *std::ranges::find_if(found, [&](const Explanation& explanation) {
    return explanation.left <= std::max(about * least, rounding);
  });
}

/// Of a picture that holds no more digits other explanations would be guesses.
std::optional<Explanation> nearly_right(const WrongPixels& pixels) {
  if (!pixels.are_stored_in_8_bits() || pixels.max_error() > 4 * half_step) return std::nullopt;
  return Explanation{Fault::eight_bits,
                     fmt::format("right to {:.1f} of an 8-bit step", 255 * pixels.max_error())};
}

std::optional<Explanation> exact(const WrongPixels& pixels) {
  Explanations found;
  for (const Kind kind : exact_kinds) kind(pixels, found);
  return best_of(found, pixels.rounding());
}

std::optional<Explanation> vague(const WrongPixels& pixels) {
  Explanations found;
  for (const Kind kind : vague_kinds)
    if (kind(pixels, found); !found.empty()) return found.front();
  return std::nullopt;
}

Explanation explanation_of(const WrongPixels& pixels) {
  for (const auto way : {nearly_right, exact, vague})
    if (auto found = way(pixels)) return *std::move(found);
  return {pixels.max_error() <= least_seen ? Fault::precision : Fault::other,
          fmt::format("{} pixels, by {:.2g} at most", pixels.wrong().size(), pixels.max_error())};
}

}  // namespace

bool is_right_to_two_steps(const Verdict& verdict) {
  return verdict.passed ||
         (verdict.fault == Fault::eight_bits && verdict.max_error <= 4 * half_step);
}

Verdict judge(const ConformanceCase& c, const Image& picture, bool stored_in_8_bits,
              double tolerance) {
  const WrongPixels pixels(c, picture, stored_in_8_bits, tolerance);
  Verdict verdict{pixels.wrong().empty(), pixels.max_error(), pixels.wrong().size()};
  if (verdict.passed) return verdict;
  Explanation explanation = explanation_of(pixels);
  verdict.fault = explanation.fault;
  verdict.explanation = std::move(explanation.text);
  return verdict;
}

}  // namespace pellucid::compare
