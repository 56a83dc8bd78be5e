// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Sums and products that know how far rounding may have moved them: the filter in front of exact
// numbers.

#include <cmath>
#include <limits>
#include <optional>

namespace pellucid::groundtruth {

/// A Bounded is a number as long double gives it, and a bound on its distance from the exact one.
/// With 64 bits, as on x86-64, a few hundredths of all quotients are too near the middle of two
/// doubles to be rounded; where long double is double nearly all are, and it filters nothing.
struct Bounded {
  long double value = 0, error = 0;

  Bounded() = default;
  explicit Bounded(double x) : value(x) {}
  Bounded(long double value_, long double error_) : value(value_), error(error_) {}

  /// A bound on a result's own rounding. Those of the bounds themselves are far less than a
  /// thousandth of them, which is left to who compares.
  static long double rounding(long double x) {
    return std::abs(x) * (std::numeric_limits<long double>::epsilon() / 2) +
           std::numeric_limits<long double>::min();
  }

  friend Bounded operator+(const Bounded& p, const Bounded& q) {
    const long double sum = p.value + q.value;
    return {sum, p.error + q.error + rounding(sum)};
  }
  friend Bounded operator-(const Bounded& p, const Bounded& q) {
    const long double difference = p.value - q.value;
    return {difference, p.error + q.error + rounding(difference)};
  }
  friend Bounded operator*(const Bounded& p, const Bounded& q) {
    const long double product = p.value * q.value;
    return {product, std::abs(p.value) * q.error + std::abs(q.value) * p.error + p.error * q.error +
                         rounding(product)};
  }
};

/// Returns p / q, rounded once to the nearest double; nothing where the bounds leave room for two.
inline std::optional<double> quotient(const Bounded& p, const Bounded& q) {
  constexpr long double for_the_bounds_own_rounding = 1.001L;
  const long double least = std::abs(q.value) - for_the_bounds_own_rounding * q.error;
  if (!(least > 0)) return std::nullopt;
  const long double value = p.value / q.value;
  const long double error =
      for_the_bounds_own_rounding *
      ((p.error + std::abs(value) * q.error) / least + Bounded::rounding(value));
  const double low = static_cast<double>(value - error), high = static_cast<double>(value + error);
  if (low != high) return std::nullopt;
  return low;
}

}  // namespace pellucid::groundtruth
