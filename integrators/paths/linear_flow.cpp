// SPDX-License-Identifier: GPL-3.0-or-later
// The exponential of a matrix by scaling and squaring: C. Moler, C. Van Loan, "Nineteen Dubious
// Ways to Compute the Exponential of a Matrix, Twenty-Five Years Later", SIAM Review 45(1), 2003,
// method 3, with the Taylor series of method 1.
#include "integrators/paths/linear_flow.h"

#include <algorithm>
#include <cmath>

namespace pellucid::integrators {
namespace {

/// The sum of all entries' sizes: no norm of a matrix that goes with one of vectors is larger.
double size_of(const Mat3& a) {
  double sum = 0;
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) sum += std::abs(a[column][row]);
  return sum;
}

/// Of matrices of a size up to 1/4: what is cut off is 0.25^15 / 15!, below 1e-21.
Mat3 taylor_series(const Mat3& a) {
  constexpr int terms = 14;
  Mat3 sum(1);
  for (int k = terms; k > 0; --k) sum = Mat3(1) + a * sum / double(k);
  return sum;
}

/// So that it can be squared.
Mat3 within_range(const Mat3& a) {
  constexpr double far = 1e100;
  const double size = size_of(a);
  return size > 0 && (size > far || size < 1 / far) ? a / size : a;
}

}  // namespace

Vec3 carried_linearly(const Mat3& a, double time, const Vec3& w) {
  const double size = size_of(a) * std::abs(time);
  if (!std::isfinite(size) || size == 0) return w;
  const int halvings = std::max(0, std::ilogb(size) + 3);
  Mat3 flow = taylor_series(a * std::ldexp(time, -halvings));
  for (int i = 0; i < halvings; ++i) flow = within_range(flow * flow);
  return flow * w;
}

}  // namespace pellucid::integrators
