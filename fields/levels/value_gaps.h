// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/vec.h"

namespace pellucid::fields {

/// ValueGaps are the values of which samples cannot give a right surface, as intervals from above
/// their low end up to their high one, which belongs to them.
class ValueGaps {
 public:
  /// Adds the values v with low < v <= high: those by which two such samples lie on either side.
  void add(double low, double high);
  void add(const ValueGaps& others);

  bool empty() const { return gaps_.empty(); }
  bool contains(double value) const;
  /// Returns the values of a range that remain, for messages: "from 0 to 1", "above -0.5 to 0.5 or
  /// above 2 to 3"; "none" of none. Numbers have as many digits as tell them from their neighbours
  /// among floats, or among doubles where they are none.
  std::string accepted(const Vec2& range) const;

 private:
  std::vector<Vec2> gaps_;  // ascending, apart from each other
};

}  // namespace pellucid::fields
