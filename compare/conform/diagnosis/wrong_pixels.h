// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <vector>

#include "compare/conform/conformance_case.h"

namespace pellucid::compare {

/// Half an 8-bit step, and what reading it back rounds.
inline constexpr double half_step = 0.5 / 255 + 1e-6;
/// What half floats in [0, 1] round.
inline constexpr double half_float_step = 0x1p-12;
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

  /// What storing the picture alone may be off by: half a step where all values are of 8 bits or of
  /// half floats, else what floats lose.
  double rounding() const { return rounding_; }
  /// What an explanation may leave of an error that is wholly known.
  double nearly_all() const { return 2 * tolerance_ + rounding_; }
  /// By how much the pixel is off a colour, which in 8 bits is shown within [0, 1].
  double off(std::size_t pixel, const Vec3& color) const;

  /// Tells, of a pixel, what an explanation leaves of its error.
  using LeftOf = std::function<double(std::size_t)>;
  /// Makes of layers all colours that an explanation has for them.
  using Colors = std::function<std::vector<Vec3>(const Layers&)>;

  /// Return the 0.9 quantile, over the wrong pixels, of what is left of their errors: by a function
  /// of each, or by the nearest of the colours of its layers. Nothing where more than a tenth of
  /// them are left with more than `most` or half of their error: what changes nothing that is seen
  /// explains nothing.
  ///@{
  std::optional<double> left_by(const LeftOf& left_of, double most) const;
  std::optional<double> left_by_nearest(const Colors& colors) const;
  ///@}
  /// Return the same of what is of the whole picture: nothing where it spoils right pixels, too.
  ///@{
  std::optional<double> left_by_all(const LeftOf& left_of, double most) const;
  std::optional<double> left_by_composite(const Composite& composite, double most) const;
  ///@}

 private:
  std::size_t may_fail() const { return wrong_.size() / 10; }

  const ConformanceCase& case_;
  const Image& picture_;
  bool stored_in_8_bits_;
  double tolerance_, rounding_, max_error_ = 0;
  std::vector<double> errors_;  // of each pixel of the picture
  std::vector<std::size_t> wrong_;
};

}  // namespace pellucid::compare
