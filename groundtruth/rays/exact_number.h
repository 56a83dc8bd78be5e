// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Numbers without rounding, and vectors of any kind of number: what decisions are made with that
// doubles cannot make.

#include <CGAL/Gmpzf.h>

#include <array>

#include "core/vec.h"

namespace pellucid::groundtruth {

/// An Exact is a binary floating-point number of unbounded mantissa: sums and products of doubles
/// without rounding, and without the common divisors that rationals have to look for.
using Exact = CGAL::Gmpzf;

/// Returns p / q, rounded once, to nearest: 0, subnormal or infinite only where no double of full
/// precision is that near. q is not 0.
double quotient(const Exact& p, const Exact& q);

/// Returns -1, 0 or 1.
///@{
inline int sign_of(double x) { return (x > 0) - (x < 0); }
inline int sign_of(const Exact& x) { return static_cast<int>(CGAL::sign(x)); }
///@}

/// A Triple is a vector of three of any kind of number.
template <class Number>
using Triple = std::array<Number, 3>;

/// Returns p in that kind of number, without rounding.
template <class Number>
Triple<Number> triple(const Vec3& p) {
  return {Number(p.x), Number(p.y), Number(p.z)};
}

/// Returns p - q.
///@{
template <class Number>
Triple<Number> difference(const Triple<Number>& p, const Triple<Number>& q) {
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}

template <class Number>
Triple<Number> difference(const Vec3& p, const Vec3& q) {
  return difference(triple<Number>(p), triple<Number>(q));
}
///@}

/// Returns p × q.
template <class Number>
Triple<Number> cross_product(const Triple<Number>& p, const Triple<Number>& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

/// Returns p · q.
template <class Number>
Number dot_product(const Triple<Number>& p, const Triple<Number>& q) {
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}

}  // namespace pellucid::groundtruth
