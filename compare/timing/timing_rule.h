// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "compare/timing/median_interval.h"

namespace pellucid::compare {

/// A TimingRule says how often a picture is timed: `min` times and, where a width is asked for, on
/// until the interval of the median is so narrow, at most `max` times, and no more often than fits
/// into so many `seconds`.
struct TimingRule {
  int min = 3, max = 3;
  /// The largest distance from the median to either end of its interval, as a part of the median.
  std::optional<double> relative = std::nullopt;
  /// The most that all times together may take; the first one is taken in any case.
  std::optional<double> seconds = std::nullopt;
};

/// Returns the rule of a fixed number of repeats.
inline TimingRule fixed_repeats(int repeats) { return {repeats, repeats}; }

/// A Spread is wall-clock seconds over the repeats.
struct Spread {
  double median = 0, min = 0, max = 0;
  std::optional<Interval> interval = std::nullopt;  // 95 % of the median; none of too few repeats
};

/// Returns the spread of times that were measured by the rule, in seconds. A rule that looks at its
/// interval after each time stops where chance has made it narrow, so that fewer than 95 % of
/// nominal 95 % intervals hold their median: 91 % in the worst simulation of
/// tests/compare/timing/timing_rule_test.cpp. Its intervals are nominally of 96.5 %, and 93 to 97 %
/// of them do.
Spread spread_of(std::span<const double> seconds, const TimingRule& rule);

/// Says whether no more times are needed: the interval is as narrow as asked, or nothing was asked
/// and there are `min`.
bool is_settled(std::span<const double> seconds, const TimingRule& rule);

/// Says whether timing ends here: it is settled, there are `max`, or another time, as long as the
/// last one, would exceed the `seconds`.
bool is_over(std::span<const double> seconds, const TimingRule& rule);

}  // namespace pellucid::compare
