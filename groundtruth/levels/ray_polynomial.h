// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

namespace pellucid::groundtruth {

/// A RayPolynomial is Σ c_i t^i (1 - t)^(degree - i): Bernstein's form with the binomials drawn
/// into the coefficients, so that a product is a convolution and no sum cancels digits that its
/// terms have. On [0, 1] it has at most as many zeros as its coefficients change sign (Descartes'
/// rule).
class RayPolynomial {
 public:
  /// The reconstruction with the most factors has this degree: five levels (most_fading) of degree
  /// 3 each.
  static constexpr int most_degree = 15;

  RayPolynomial() = default;
  RayPolynomial(double constant) { c_[0] = constant; }  // NOLINT(google-explicit-constructor)
  /// Makes the line from `begin` at t = 0 to `end` at t = 1.
  RayPolynomial(double begin, double end) : degree_(1) {
    c_[0] = begin;
    c_[1] = end;
  }

  double operator()(double t) const;
  double begin() const { return c_[0]; }
  double end() const { return c_[std::size_t(degree_)]; }
  void set_begin(double value) { c_[0] = value; }
  void set_end(double value) { c_[std::size_t(degree_)] = value; }
  double largest_coefficient() const;
  /// Returns the first, or the last, coefficient that is beyond ± `tolerance`, cut down to that: it
  /// has the polynomial's sign next to an end where it is 0. 0 when there is none.
  ///@{
  double first_beyond(double tolerance) const;
  double last_beyond(double tolerance) const;
  ///@}
  /// Counts where neighbouring coefficients differ in sign; one that is 0 counts as positive.
  int sign_changes() const;
  /// Returns its halves, each over [0, 1] again.
  std::array<RayPolynomial, 2> split() const;

  friend RayPolynomial operator+(const RayPolynomial& p, const RayPolynomial& q);
  friend RayPolynomial operator*(const RayPolynomial& p, const RayPolynomial& q) {
    if (q.degree_ == 0) return p.times(q.c_[0]);
    if (p.degree_ == 0) return q.times(p.c_[0]);
    return p.times(q);
  }
  friend RayPolynomial operator-(const RayPolynomial& p, const RayPolynomial& q) {
    return p + RayPolynomial(-1.0) * q;
  }
  friend RayPolynomial operator/(const RayPolynomial& p, double q) {
    return p * RayPolynomial(1 / q);
  }
  /// Returns (x - origin) / width - low of a line, at its ends as that of a point there.
  friend RayPolynomial lattice_coordinate(const RayPolynomial& x, double origin, double width,
                                          int low) {
    return {(x.begin() - origin) / width - low, (x.end() - origin) / width - low};
  }
  /// Returns fields::trilinear_form() of lines. The form is linear in each coordinate, so that its
  /// coefficients are sums of its values with some coordinates at the lines' begins and the others
  /// at their ends: the i-th of those with i at their ends.
  friend RayPolynomial trilinear_form(const std::array<RayPolynomial, 3>& s,
                                      const std::array<double, 8>& f);

 private:
  RayPolynomial elevated(int degree) const;
  RayPolynomial times(const RayPolynomial& q) const;
  RayPolynomial times(double factor) const {
    RayPolynomial out = *this;
    for (std::size_t i = 0; i <= std::size_t(degree_); ++i) out.c_[i] *= factor;
    return out;
  }

  int degree_ = 0;
  std::array<double, most_degree + 1> c_{};
};

/// Appends every t in [0, 1] where the polynomial changes sign (0 counts as positive), ascending:
/// the interval is halved until Descartes' rule says none or one, and one is bracketed to the last
/// bits. Two that no half of 2^-48 separates are none: the polynomial keeps its sign beyond them.
void append_sign_changes(const RayPolynomial& p, std::vector<double>& at);

}  // namespace pellucid::groundtruth
