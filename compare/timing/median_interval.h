// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

namespace pellucid::compare {

/// An Interval is where a number lies by what was measured; ends included, in the number's unit.
struct Interval {
  double low = 0, high = 0;
};

/// Says whether the two intervals have a number in common: what they are of cannot be told apart.
bool overlap(const Interval& a, const Interval& b);

/// The part of all intervals that hold their median, unless another one is asked for.
constexpr double usual_confidence = 0.95;

/// Returns the median; of an even number of values the mean of the middle two. There has to be one.
double median_of(std::vector<double> values);

/// Returns an interval that holds the median of what the values were drawn from with this
/// probability, whatever their distribution. The number of values below the median is binomial, so
/// that [x_(d), x_(n+1-d)] of the sorted values holds it with probability
///
///     γ_d = 1 - 2 P(B < d),  B ~ Bin(n, 1/2).
///
/// Between the last d with γ_d of at least the confidence and the next one it interpolates, as
/// Hettmansperger, Sheather, Confidence intervals based on interpolated order statistics,
/// Statistics & Probability Letters 4 (1986), by I = (γ_d - γ) / (γ_d - γ_(d+1)) and λ = (n - d) I
/// / (d + (n - 2 d) I). This holds for any distribution to within one in a hundred
/// (tests/compare/timing/median_interval_test.cpp prints the parts of skewed ones).
///
/// From too few values it returns [min, max], which holds the median with 1 - 2^(1-n): 0.94 for
/// five, the fewest of which it makes an interval. Returns nothing for fewer.
std::optional<Interval> median_interval(std::vector<double> values,
                                        double confidence = usual_confidence);

}  // namespace pellucid::compare
