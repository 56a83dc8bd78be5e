// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace pellucid::scene {

/// A RadiusSpan is the radii of points that follow each other, world units; it views a Radii.
class RadiusSpan {
 public:
  /// All have this radius.
  RadiusSpan(double one) : one_(one) {}
  explicit RadiusSpan(std::span<const double> each) : each_(each) {}

  double at(std::size_t i) const { return each_.empty() ? one_ : each_[i]; }
  /// Returns whether each has its own.
  bool vary() const { return !each_.empty(); }
  double largest() const;

 private:
  double one_ = 0;
  std::span<const double> each_;
};

/// Radii are how wide the points of an object are drawn, in world units, none below 0: one radius
/// of all, which takes no memory, or one of each, 8 bytes a point. Between two points of a line the
/// radius is linear.
class Radii {
 public:
  /// All points have this radius.
  Radii(double one = 0) : largest_(one) {}
  /// Takes the radius of each point. Equal radii become one.
  explicit Radii(std::vector<double> each);

  double at(std::size_t i) const { return each_.empty() ? largest_ : each_[i]; }
  /// Returns whether there are points of different radii.
  bool vary() const { return !each_.empty(); }
  double largest() const { return largest_; }
  /// Returns those of `count` points from `first` on.
  RadiusSpan of(std::size_t first, std::size_t count) const {
    return each_.empty() ? RadiusSpan(largest_)
                         : RadiusSpan(std::span(each_).subspan(first, count));
  }

  Radii& operator*=(double factor);  // which is not below 0
  bool operator==(const Radii&) const = default;

 private:
  double largest_;
  std::vector<double> each_;  // empty: all are the largest
};

}  // namespace pellucid::scene
