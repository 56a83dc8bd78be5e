// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/levels/sample_scale.h"

#include <algorithm>
#include <cmath>

namespace pellucid::fields {

SampleScale::SampleScale(double offset, double low, double high) {
  // By halves: the largest doubles are twice as far from each other as a double reaches.
  const double farthest = std::max(std::abs(offset / 2 - low / 2), std::abs(high / 2 - offset / 2));
  if (!(farthest > 0)) return;
  const int exponent = std::clamp(std::ilogb(farthest) + 1, -1020, 1020);
  unit_ = std::ldexp(1, exponent);
  per_unit_ = std::ldexp(1, -exponent);
  kept_offset_ = offset * per_unit_;
}

}  // namespace pellucid::fields
