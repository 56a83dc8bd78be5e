// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/levels/box_polynomial.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace pellucid::fields {
namespace {

double binomial(int n, int k) {
  double value = 1;
  for (int i = 1; i <= k; ++i) value = value * (n - k + i) / i;
  return value;
}

}  // namespace

template <class Call>
void BoxPolynomial::for_each(const Call& call) const {
  for (int k = 0; k <= degrees_[2]; ++k)
    for (int j = 0; j <= degrees_[1]; ++j)
      for (int i = 0; i <= degrees_[0]; ++i) call(i, j, k);
}

BoxPolynomial BoxPolynomial::line(int axis, double begin, double end) {
  BoxPolynomial p;
  p.degrees_[std::size_t(axis)] = 1;
  p.c_[0] = begin;
  p.c_[1] = end;
  return p;
}

int BoxPolynomial::degree() const { return *std::ranges::max_element(degrees_); }

void BoxPolynomial::append_coefficients(int degree, std::vector<double>& out) const {
  const BoxPolynomial p = elevated({degree, degree, degree});
  p.for_each([&](int i, int j, int k) {
    out.push_back(p.c_[p.index(i, j, k)] /
                  (binomial(degree, i) * binomial(degree, j) * binomial(degree, k)));
  });
}

BoxPolynomial on_lattice(BoxPolynomial line) {
  constexpr double rounding = 1e-10;  // lattice coordinates up to 1e4 carry 1e-12 each
  line.for_each([&](int i, int j, int k) {
    double& end = line.c_[line.index(i, j, k)];
    if (std::abs(end - std::round(end)) < rounding) end = std::round(end);
  });
  return line;
}

BoxPolynomial BoxPolynomial::elevated(int axis) const {  // times t + (1 - t)
  BoxPolynomial out;
  out.degrees_ = degrees_;
  assert(degrees_[std::size_t(axis)] < most_degree);
  ++out.degrees_[std::size_t(axis)];
  out.for_each([&](int i, int j, int k) { out.c_[out.index(i, j, k)] = 0; });
  for_each([&](int i, int j, int k) {
    const double c = c_[index(i, j, k)];
    out.c_[out.index(i, j, k)] += c;
    out.c_[out.index(i + (axis == 0), j + (axis == 1), k + (axis == 2))] += c;
  });
  return out;
}

BoxPolynomial BoxPolynomial::elevated(const Degrees& degrees) const {
  BoxPolynomial out = *this;
  for (int axis = 0; axis < 3; ++axis)
    while (out.degrees_[std::size_t(axis)] < degrees[std::size_t(axis)]) out = out.elevated(axis);
  return out;
}

BoxPolynomial operator+(const BoxPolynomial& p, const BoxPolynomial& q) {
  BoxPolynomial::Degrees degrees;
  std::ranges::transform(p.degrees_, q.degrees_, degrees.begin(),
                         [](int a, int b) { return std::max(a, b); });
  BoxPolynomial out = p.elevated(degrees);
  const BoxPolynomial other = q.elevated(degrees);
  out.for_each(
      [&](int i, int j, int k) { out.c_[out.index(i, j, k)] += other.c_[out.index(i, j, k)]; });
  return out;
}

BoxPolynomial operator*(const BoxPolynomial& p, const BoxPolynomial& q) {
  BoxPolynomial out;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    out.degrees_[axis] = p.degrees_[axis] + q.degrees_[axis];
    assert(out.degrees_[axis] <= BoxPolynomial::most_degree);
  }
  out.for_each([&](int i, int j, int k) { out.c_[out.index(i, j, k)] = 0; });
  p.for_each([&](int i, int j, int k) {
    const double c = p.c_[p.index(i, j, k)];
    q.for_each([&](int a, int b, int d) {
      out.c_[out.index(i + a, j + b, k + d)] += c * q.c_[q.index(a, b, d)];
    });
  });
  return out;
}

}  // namespace pellucid::fields
