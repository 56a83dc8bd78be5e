// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "core/vec.h"

namespace pellucid::fields {

/// A Dual is a number with its three derivatives: forward-mode automatic differentiation. A flow
/// written over its scalar type gives its exact Jacobian when it is evaluated with Duals.
struct Dual {
  double value = 0;
  Vec3 gradient{0};

  Dual() = default;
  Dual(double value_) : value(value_) {}  // NOLINT(google-explicit-constructor): constants mix in
  Dual(double value_, const Vec3& gradient_) : value(value_), gradient(gradient_) {}
};

/// These operators compute values as for doubles, and gradients by the rules of sum, product and
/// quotient; comparisons look at the values alone.
///@{
inline Dual operator-(const Dual& a) { return {-a.value, -a.gradient}; }
inline Dual operator+(const Dual& a, const Dual& b) {
  return {a.value + b.value, a.gradient + b.gradient};
}
inline Dual operator-(const Dual& a, const Dual& b) {
  return {a.value - b.value, a.gradient - b.gradient};
}
inline Dual operator*(const Dual& a, const Dual& b) {
  return {a.value * b.value, a.gradient * b.value + b.gradient * a.value};
}
inline Dual operator/(const Dual& a, const Dual& b) {
  const double quotient = a.value / b.value;
  return {quotient, (a.gradient - quotient * b.gradient) / b.value};
}
inline bool operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
inline bool operator>(const Dual& a, const Dual& b) { return a.value > b.value; }
///@}

/// These functions compute values as the standard library does, and gradients by the chain rule.
///@{
inline Dual sin(const Dual& a) { return {std::sin(a.value), std::cos(a.value) * a.gradient}; }
inline Dual cos(const Dual& a) { return {std::cos(a.value), -std::sin(a.value) * a.gradient}; }
inline Dual exp(const Dual& a) {
  const double power = std::exp(a.value);
  return {power, power * a.gradient};
}
inline Dual tanh(const Dual& a) {
  const double t = std::tanh(a.value);
  return {t, (1 - t * t) * a.gradient};
}
inline Dual log(const Dual& a) { return {std::log(a.value), a.gradient / a.value}; }
inline Dual abs(const Dual& a) { return a.value < 0 ? -a : a; }
///@}

/// Returns the square root. At 0 its derivative is taken as 0: a flow's sqrt is a distance, and the
/// mean slope of a cone at its tip is 0.
inline Dual sqrt(const Dual& a) {
  const double root = std::sqrt(a.value);
  return {root, root > 0 ? a.gradient / (2 * root) : Vec3(0)};
}

}  // namespace pellucid::fields
