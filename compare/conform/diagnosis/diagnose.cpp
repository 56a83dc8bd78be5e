// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/conform/diagnosis/diagnose.h"

#include <fmt/format.h>

#include "compare/conform/diagnosis/explanations.h"

namespace pellucid::compare {
namespace {

/// In the order in which they are looked for: what takes the least for granted comes first.
constexpr std::optional<Explanation> (*kinds[])(const WrongPixels&) = {
    nearly_right,    over_another_background,
    through_a_curve, of_8_bits,
    of_half_floats,  missed,
    capped,          doubled,
    clamped,         of_the_picture,
    misordered};

Explanation explanation_of(const WrongPixels& pixels) {
  for (const auto& kind : kinds)
    if (auto found = kind(pixels)) return *std::move(found);
  return {pixels.max_error() <= least_seen ? Fault::precision : Fault::other,
          fmt::format("{} pixels, by {:.2g} at most", pixels.wrong().size(), pixels.max_error())};
}

}  // namespace

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
