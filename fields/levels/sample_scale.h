// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace pellucid::fields {

/// A SampleScale says for which values a field's samples stand, which are floats: for themselves,
/// or for unit × sample + offset, where values in doubles differ by less than a float tells apart.
class SampleScale {
 public:
  /// Samples stand for themselves.
  SampleScale() = default;
  /// Samples count from `offset` on, the farther of `low` and `high` being of the size of 1: a
  /// value is then kept within 6e-8 of its distance from the offset.
  SampleScale(double offset, double low, double high);

  /// Returns the number that is kept of a value; exactly 0 of the offset.
  double kept(double value) const { return value * per_unit_ - kept_offset_; }
  /// Returns the value of which `kept` is kept.
  double value(double kept) const { return (kept + kept_offset_) * unit_; }

 private:
  double unit_ = 1, per_unit_ = 1;  // powers of two, by which nothing is rounded
  double kept_offset_ = 0;          // in units
};

}  // namespace pellucid::fields
