// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The segments of a set of lines, counted from line to line.

#include <cstdint>
#include <vector>

#include "geometry/line_set.h"
#include "groundtruth/shapes/vertex_blend.h"

namespace pellucid::groundtruth {

class LineSegments {
 public:
  /// The set has to outlive it. Throws InputError for 2^31 segments or more.
  explicit LineSegments(const geometry::LineSet& set);

  std::uint32_t count() const { return static_cast<std::uint32_t>(first_points_.size()); }
  /// The segment joins this point and the next.
  std::uint32_t first_point(std::uint32_t segment) const { return first_points_[segment]; }
  /// The line that the segment belongs to.
  std::uint32_t line(std::uint32_t segment) const;
  /// `along`: 0 at the segment's first point, 1 at its second.
  VertexBlend<2> blend(std::uint32_t segment, double along) const {
    return {{first_points_[segment], first_points_[segment] + 1}, {1 - along, along}};
  }
  /// line_direction of the segment's points, normalized, interpolated.
  Vec3 direction(std::uint32_t segment, double along) const;

  std::uint64_t bytes() const { return first_points_.size() * sizeof(std::uint32_t); }

 private:
  const geometry::LineSet& set_;
  std::vector<std::uint32_t> first_points_;
};

}  // namespace pellucid::groundtruth
