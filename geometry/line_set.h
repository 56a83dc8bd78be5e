// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/vertices.h"

namespace pellucid::geometry {

/// A LineSet holds polylines: line k joins the points offsets[k] … offsets[k + 1] - 1. A line of
/// one point or of none has no segment.
struct LineSet : Vertices {
  std::vector<std::uint64_t> offsets{0};

  std::size_t line_count() const { return offsets.size() - 1; }
  std::size_t segment_count() const {
    std::size_t count = 0;
    for (std::size_t k = 0; k < line_count(); ++k)
      if (const std::uint64_t points = offsets[k + 1] - offsets[k]; points > 1) count += points - 1;
    return count;
  }
};

}  // namespace pellucid::geometry
