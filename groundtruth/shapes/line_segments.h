// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The segments of a set of lines, counted from line to line.

#include <cstdint>
#include <memory>
#include <vector>

#include "geometry/line_set.h"
#include "groundtruth/rays/view_frame.h"
#include "groundtruth/shapes/segment_groups.h"
#include "groundtruth/shapes/vertex_blend.h"

namespace pellucid::groundtruth {

/// LineSegments number the segments of a set of lines, from line to line, and group those that are
/// boxes of the hierarchy together.
class LineSegments {
 public:
  /// The set has to outlive it. Groups are no longer than a packet of rays is wide; those of
  /// `before` are taken where it is not null and has as many segments. Throws InputError for 2^31
  /// segments or more.
  LineSegments(const geometry::LineSet& set, const ViewFrame& frame, const LineSegments* before);

  std::uint32_t count() const { return static_cast<std::uint32_t>(first_points_.size()); }
  /// Returns the point that the segment joins with the next one.
  std::uint32_t first_point(std::uint32_t segment) const { return first_points_[segment]; }
  /// Returns the line that the segment belongs to.
  std::uint32_t line(std::uint32_t segment) const;
  /// Returns the blend of the segment's points at `along`: 0 at the first, 1 at the second.
  VertexBlend<2> blend(std::uint32_t segment, double along) const {
    return {{first_points_[segment], first_points_[segment] + 1}, {1 - along, along}};
  }
  /// Returns line_direction() of the segment's points, normalized, then interpolated; in the
  /// world's axes.
  Vec3 direction(std::uint32_t segment, double along) const;

  const SegmentGroups& groups() const { return *groups_; }
  std::uint64_t bytes() const {
    return first_points_.size() * sizeof(std::uint32_t) + groups_->bytes();
  }

 private:
  const geometry::LineSet& set_;
  std::vector<std::uint32_t> first_points_;
  std::shared_ptr<const SegmentGroups> groups_;
};

}  // namespace pellucid::groundtruth
