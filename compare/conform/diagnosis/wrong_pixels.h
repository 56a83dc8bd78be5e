// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <functional>
#include <vector>

#include "compare/conform/conformance_case.h"

namespace pellucid::compare {

/// Half an 8-bit step, and what reading it back rounds.
inline constexpr double half_step = 0.5 / 255 + 1e-6;
/// What errs by no more looks right, and is in another order by no means.
inline constexpr double least_seen = 0.02;

/// WrongPixels are those of a picture that are not as the case has them.
class WrongPixels {
 public:
  /// Makes a colour of layers, the nearest first, and of what is behind them.
  using Composite = std::function<glm::dvec4(const Layers&, const Vec3&)>;

  /// Takes what a right picture may be off by, over red, green and blue; of one that is stored in 8
  /// bits half a step more. Case and picture have to outlive it.
  WrongPixels(const ConformanceCase& conformance_case, const Image& picture, bool stored_in_8_bits,
              double tolerance);

  const ConformanceCase& conformance_case() const { return case_; }
  const Image& picture() const { return picture_; }
  bool are_stored_in_8_bits() const { return stored_in_8_bits_; }
  double tolerance() const { return tolerance_; }
  double max_error() const { return max_error_; }                   // of all pixels of the picture
  const std::vector<std::size_t>& wrong() const { return wrong_; }  // their numbers

  double error(std::size_t pixel) const { return errors_[pixel]; }
  const Rgba& shown(std::size_t pixel) const { return picture_.pixels[pixel]; }
  const Layers& layers(std::size_t pixel) const { return case_.of_pixel(pixel); }
  const Vec3& behind() const { return case_.scene.background; }

  /// Returns whether the pixel is of this colour, and that leaves less than half of its error: what
  /// changes nothing that is seen explains nothing.
  bool is(std::size_t pixel, const glm::dvec4& color, double tolerance) const;

  /// Returns whether a test of pixels holds for nine tenths of those that are wrong.
  template <class Holds>
  bool explains(const Holds& holds) const {
    constexpr double most = 0.9;
    const auto explained = std::count_if(wrong_.begin(), wrong_.end(), holds);
    return double(explained) >= most * double(wrong_.size());
  }
  /// Returns whether such a composite of each pixel's layers explains them.
  bool is_composite(const Composite& composite, double tolerance) const;

 private:
  const ConformanceCase& case_;
  const Image& picture_;
  bool stored_in_8_bits_;
  double tolerance_, max_error_ = 0;
  std::vector<double> errors_;  // of each pixel of the picture
  std::vector<std::size_t> wrong_;
};

}  // namespace pellucid::compare
