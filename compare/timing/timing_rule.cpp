// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/timing/timing_rule.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <vector>

namespace pellucid::compare {
namespace {

/// Nominal, of intervals that decide when to stop.
constexpr double stopping_confidence = 0.965;

bool is_narrow(const Spread& spread, double relative) {
  if (!spread.interval) return false;
  const auto [low, high] = *spread.interval;
  return std::max(high - spread.median, spread.median - low) <= relative * spread.median;
}

}  // namespace

Spread spread_of(std::span<const double> seconds, const TimingRule& rule) {
  assert(!seconds.empty());
  const std::vector<double> values(seconds.begin(), seconds.end());
  const auto [least, most] = std::ranges::minmax(values);
  return {median_of(values), least, most,
          median_interval(values, rule.relative ? stopping_confidence : usual_confidence)};
}

bool is_settled(std::span<const double> seconds, const TimingRule& rule) {
  if (seconds.size() < std::size_t(rule.min)) return false;
  return !rule.relative || is_narrow(spread_of(seconds, rule), *rule.relative);
}

bool is_over(std::span<const double> seconds, const TimingRule& rule) {
  if (seconds.size() >= std::size_t(rule.max) || is_settled(seconds, rule)) return true;
  if (!rule.seconds || seconds.empty()) return false;
  return std::accumulate(seconds.begin(), seconds.end(), seconds.back()) > *rule.seconds;
}

}  // namespace pellucid::compare
