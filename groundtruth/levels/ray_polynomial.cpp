// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/levels/ray_polynomial.h"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

namespace pellucid::groundtruth {
namespace {

constexpr int most_halvings = 48;

double binomial(int n, int k) {
  double value = 1;
  for (int i = 1; i <= k; ++i) value = value * (n - k + i) / i;
  return value;
}

/// The one sign change of a polynomial whose ends differ in sign.
double bracketed(const RayPolynomial& p) {
  if (p.begin() == 0) return 0;
  if (p.end() == 0) return 1;
  std::uintmax_t steps = 100;
  const auto [low, high] = boost::math::tools::toms748_solve(
      [&](double t) { return p(t); }, 0.0, 1.0, p.begin(), p.end(),
      boost::math::tools::eps_tolerance<double>(52), steps);
  return 0.5 * (low + high);
}

void isolate(const RayPolynomial& p, double from, double length, int halvings,
             std::vector<double>& at) {
  const int changes = p.sign_changes();
  if (changes == 0) return;
  const bool ends_differ = (p.begin() < 0) != (p.end() < 0);
  if (changes == 1 || halvings == 0) {
    if (ends_differ) at.push_back(from + length * bracketed(p));
    return;
  }
  const auto halves = p.split();
  isolate(halves[0], from, length / 2, halvings - 1, at);
  isolate(halves[1], from + length / 2, length / 2, halvings - 1, at);
}

}  // namespace

double RayPolynomial::operator()(double t) const {
  // Horner in t / (1 - t) or its inverse, whichever is at most 1.
  const bool low = t <= 0.5;
  const double u = low ? t / (1 - t) : (1 - t) / t;
  double value = 0;
  for (int i = 0; i <= degree_; ++i) value = value * u + c_[std::size_t(low ? degree_ - i : i)];
  return value * std::pow(low ? 1 - t : t, degree_);
}

double RayPolynomial::largest_coefficient() const {
  double largest = 0;
  for (int i = 0; i <= degree_; ++i) largest = std::max(largest, std::abs(c_[std::size_t(i)]));
  return largest;
}

double RayPolynomial::first_beyond(double tolerance) const {
  for (int i = 0; i <= degree_; ++i)
    if (const double c = c_[std::size_t(i)]; std::abs(c) > tolerance)
      return std::copysign(tolerance, c);
  return 0;
}

double RayPolynomial::last_beyond(double tolerance) const {
  for (int i = degree_; i >= 0; --i)
    if (const double c = c_[std::size_t(i)]; std::abs(c) > tolerance)
      return std::copysign(tolerance, c);
  return 0;
}

int RayPolynomial::sign_changes() const {
  int changes = 0;
  for (std::size_t i = 0; i < std::size_t(degree_); ++i) changes += (c_[i] < 0) != (c_[i + 1] < 0);
  return changes;
}

std::array<RayPolynomial, 2> RayPolynomial::split() const {
  // de Casteljau's scheme on the coefficients without their binomials.
  const auto n = std::size_t(degree_);
  std::array<double, most_degree + 1> b{};
  for (std::size_t i = 0; i <= n; ++i) b[i] = c_[i] / binomial(degree_, int(i));
  RayPolynomial left, right;
  left.degree_ = right.degree_ = degree_;
  for (std::size_t round = 0; round <= n; ++round) {
    left.c_[round] = b[0] * binomial(degree_, int(round));
    right.c_[n - round] = b[n - round] * binomial(degree_, int(round));
    for (std::size_t i = 0; i + round < n; ++i) b[i] = 0.5 * (b[i] + b[i + 1]);
  }
  return {left, right};
}

RayPolynomial RayPolynomial::elevated(int degree) const {
  RayPolynomial out = *this;
  for (; out.degree_ < degree; ++out.degree_)  // times t + (1 - t)
    for (auto i = std::size_t(out.degree_) + 1; i > 0; --i) out.c_[i] += out.c_[i - 1];
  return out;
}

RayPolynomial operator+(const RayPolynomial& p, const RayPolynomial& q) {
  if (p.degree_ < q.degree_) return q + p.elevated(q.degree_);
  if (q.degree_ < p.degree_) return p + q.elevated(p.degree_);
  RayPolynomial out = p;
  for (std::size_t i = 0; i <= std::size_t(p.degree_); ++i) out.c_[i] += q.c_[i];
  return out;
}

RayPolynomial RayPolynomial::times(const RayPolynomial& q) const {
  RayPolynomial out;
  out.degree_ = degree_ + q.degree_;
  for (std::size_t i = 0; i <= std::size_t(degree_); ++i)
    for (std::size_t j = 0; j <= std::size_t(q.degree_); ++j) out.c_[i + j] += c_[i] * q.c_[j];
  return out;
}

RayPolynomial trilinear_form(const std::array<RayPolynomial, 3>& s,
                             const std::array<double, 8>& f) {
  const auto between = [](double a, double b, double at) { return (1 - at) * a + at * b; };
  // By how many coordinates are at their ends.
  std::array<double, 4> sums{};
  for (const std::size_t i : {0u, 1u}) {
    const double x = i == 0 ? s[0].begin() : s[0].end();
    const double edges[] = {between(f[0], f[1], x), between(f[2], f[3], x), between(f[4], f[5], x),
                            between(f[6], f[7], x)};
    for (const std::size_t j : {0u, 1u}) {
      const double y = j == 0 ? s[1].begin() : s[1].end();
      const double low = between(edges[0], edges[1], y), high = between(edges[2], edges[3], y);
      sums[i + j] += between(low, high, s[2].begin());
      sums[i + j + 1] += between(low, high, s[2].end());
    }
  }
  RayPolynomial out;
  out.degree_ = 3;
  std::ranges::copy(sums, out.c_.begin());
  return out;
}

void append_sign_changes(const RayPolynomial& p, std::vector<double>& at) {
  isolate(p, 0, 1, most_halvings, at);
}

}  // namespace pellucid::groundtruth
