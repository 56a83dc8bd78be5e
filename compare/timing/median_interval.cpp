// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/timing/median_interval.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace pellucid::compare {
namespace {

constexpr std::size_t fewest_values = 5;

/// An OrderStatistic stands between the d-th and the next of sorted values, d from 1.
struct OrderStatistic {
  std::size_t d = 1;
  double lambda = 0;  // share of the next
};

/// Returns P(B = k) of B ~ Bin(n, 1/2). By logarithms: 2^-n is 0 from n = 1075 on.
double probability(std::size_t k, std::size_t n) {
  const double choose = std::lgamma(n + 1.0) - std::lgamma(k + 1.0) - std::lgamma(n - k + 1.0);
  return std::exp(choose - double(n) * std::log(2.0));
}

/// Returns how far from either end of n sorted values the interval ends.
OrderStatistic end_of_interval(std::size_t n, double confidence) {
  OrderStatistic end;
  double here = 1 - 2 * probability(0, n);  // γ_d
  if (here <= confidence) return end;
  double next = here - 2 * probability(1, n);
  for (; next >= confidence; ++end.d) {
    here = next;
    next -= 2 * probability(end.d + 1, n);
  }
  const double part = (here - confidence) / (here - next);
  const double below = double(end.d), above = double(n) - below;
  end.lambda = above * part / (below + (above - below) * part);
  return end;
}

}  // namespace

bool overlap(const Interval& a, const Interval& b) { return a.low <= b.high && b.low <= a.high; }

double median_of(std::vector<double> values) {
  assert(!values.empty());
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return (values[(n - 1) / 2] + values[n / 2]) / 2;
}

std::optional<Interval> median_interval(std::vector<double> values, double confidence) {
  if (values.size() < fewest_values) return std::nullopt;
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  const auto [d, lambda] = end_of_interval(n, confidence);
  return Interval{std::lerp(values[d - 1], values[d], lambda),
                  std::lerp(values[n - d], values[n - d - 1], lambda)};
}

}  // namespace pellucid::compare
