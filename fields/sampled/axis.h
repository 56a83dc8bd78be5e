// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace pellucid::fields {

/// A Stencil says how the samples of a grid weigh in, along one axis, at one place: `value` gives
/// the interpolant, `slope` its derivative along the axis, for the N samples from `first` on.
template <int N>
struct Stencil {
  std::size_t first;
  std::array<double, N> value;
  std::array<double, N> slope;
};

/// An Axis holds the positions of a grid's samples along one axis, in grid coordinates: two or
/// more, ascending.
class Axis {
 public:
  /// Says whether `count` positions with this spacing are finite and ascend, and cells have a width
  /// that can be divided by.
  static bool can_be_uniform(double first, double spacing, std::size_t count);
  /// Takes positions for which can_be_uniform() holds.
  static Axis uniform(double first, double spacing, std::size_t count);
  /// Takes positions as they are; they ascend strictly.
  explicit Axis(std::vector<double> positions);

  std::size_t size() const { return positions_.size(); }
  double front() const { return positions_.front(); }
  double back() const { return positions_.back(); }
  double position(std::size_t i) const { return positions_[i]; }
  double width(std::size_t cell) const { return positions_[cell + 1] - positions_[cell]; }
  double smallest_width() const;
  /// Returns the spacing of an axis made by uniform(), 0 of others.
  double uniform_spacing() const { return inverse_spacing_ > 0 ? 1 / inverse_spacing_ : 0; }

  /// A Place says where a position lies among the samples.
  struct Place {
    std::size_t cell;      // between samples `cell` and `cell` + 1
    double s;              // from 0 to 1 across the cell
    double inverse_width;  // of the cell
  };
  /// Finds the cell of p, which lies in [front(), back()].
  Place locate(double p) const {
    if (inverse_spacing_ > 0) {
      const double t = (p - positions_.front()) * inverse_spacing_;
      const auto last = static_cast<std::ptrdiff_t>(positions_.size()) - 2;
      const auto i = std::min(static_cast<std::ptrdiff_t>(t), last);
      return {static_cast<std::size_t>(i), t - static_cast<double>(i), inverse_spacing_};
    }
    const auto above = std::upper_bound(positions_.begin() + 1, positions_.end() - 1, p);
    const auto i = static_cast<std::size_t>(above - positions_.begin()) - 1;
    const double inverse_width = 1 / width(i);
    return {i, (p - positions_[i]) * inverse_width, inverse_width};
  }

 private:
  std::vector<double> positions_;
  double inverse_spacing_ = 0;  // 0: positions are not evenly spaced
};

/// A ConstantInterpolation gives a whole cell its one sample: samples are between the positions,
/// one fewer than these.
class ConstantInterpolation {
 public:
  static constexpr int support = 1;
  static constexpr const char* name = "constant in cells";

  explicit ConstantInterpolation(const Axis&) {}

  Stencil<1> stencil(const Axis& axis, double p) const { return {axis.locate(p).cell, {1}, {0}}; }
};

/// A LinearInterpolation draws straight lines between samples: it is continuous.
class LinearInterpolation {
 public:
  static constexpr int support = 2;
  static constexpr const char* name = "linear";

  explicit LinearInterpolation(const Axis&) {}

  Stencil<2> stencil(const Axis& axis, double p) const {
    const auto [i, s, slope] = axis.locate(p);
    return {i, {1 - s, s}, {-slope, slope}};
  }
};

/// A CubicInterpolation joins cubic Hermite pieces whose slope at a sample is that of the parabola
/// through it and its neighbours (at an end: through the last three): it is continuous with its
/// derivative. On even spacing this is the cubic convolution of R. G. Keys, IEEE Trans. ASSP 29
/// (1981), Eq. 15 with a = -1/2 and its boundary condition, Eq. 19: third order, exact for
/// parabolas. It needs 4 samples.
class CubicInterpolation {
 public:
  static constexpr int support = 4;
  static constexpr const char* name = "c1";

  explicit CubicInterpolation(const Axis& axis);

  Stencil<4> stencil(const Axis& axis, double p) const;

 private:
  struct Slope {
    std::size_t first;             // weighs samples first … first + 2
    std::array<double, 3> weight;  // of the derivative at the node
  };
  std::vector<Slope> slopes_;  // one per sample
};

}  // namespace pellucid::fields
