// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

namespace pellucid::fields {

/// A BoxPolynomial is a polynomial over a box, [0, 1] along each axis: a product of Bernstein's
/// forms, Σ c_ijk Π t^i (1 - t)^(degree - i), with the binomials drawn into the coefficients, so
/// that a product is a convolution and no sum cancels digits that its terms have.
class BoxPolynomial {
 public:
  /// Levels that fade have this degree along an axis: four hats and a line (most_fading).
  static constexpr int most_degree = 5;

  BoxPolynomial() : BoxPolynomial(0.0) {}
  BoxPolynomial(double constant) { c_[0] = constant; }  // NOLINT(google-explicit-constructor)
  /// Makes the line along an axis from `begin` at 0 to `end` at 1, the same along the others.
  static BoxPolynomial line(int axis, double begin, double end);

  /// Returns the largest of its degrees along the axes.
  int degree() const;
  /// Returns a lattice coordinate within a cell, with an end that rounding put beside one of the
  /// cell's faces on it: pieces on both sides of a face then have the same numbers there.
  friend BoxPolynomial on_lattice(BoxPolynomial line);
  /// Appends Bernstein's coefficients, (degree + 1)³ of them, x fastest; the first and the last are
  /// the values at the first and the last corner. `degree` is at least degree().
  void append_coefficients(int degree, std::vector<double>& out) const;

  friend BoxPolynomial operator+(const BoxPolynomial& p, const BoxPolynomial& q);
  friend BoxPolynomial operator*(const BoxPolynomial& p, const BoxPolynomial& q);
  friend BoxPolynomial operator-(const BoxPolynomial& p, const BoxPolynomial& q) {
    return p + BoxPolynomial(-1.0) * q;
  }
  friend BoxPolynomial operator/(const BoxPolynomial& p, double q) {
    return p * BoxPolynomial(1 / q);
  }
  friend BoxPolynomial lattice_coordinate(const BoxPolynomial& x, double origin, double width,
                                          int low) {
    return on_lattice((x - origin) / width - double(low));
  }

 private:
  using Degrees = std::array<int, 3>;

  std::size_t index(int i, int j, int k) const {
    const auto wide = std::size_t(degrees_[0]) + 1, high = std::size_t(degrees_[1]) + 1;
    return std::size_t(i) + wide * (std::size_t(j) + high * std::size_t(k));
  }
  /// Returns the same polynomial, of one degree more along an axis.
  BoxPolynomial elevated(int axis) const;
  BoxPolynomial elevated(const Degrees& degrees) const;
  /// Calls call(i, j, k) for every coefficient.
  template <class Call>
  void for_each(const Call& call) const;

  Degrees degrees_{};
  /// As many as the degrees ask for, x fastest, without gaps; the others are not initialized.
  std::array<double, (most_degree + 1) * (most_degree + 1) * (most_degree + 1)> c_;
};

}  // namespace pellucid::fields
