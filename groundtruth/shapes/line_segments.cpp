// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/shapes/line_segments.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "core/error.h"
#include "groundtruth/shapes/crossing_geometry.h"
#include "scene/view/ribbon.h"

namespace pellucid::groundtruth {
namespace {

Vec3 unit(const Vec3& x) {
  const double length = glm::length(x);
  return length > 0 ? x / length : x;
}

}  // namespace

LineSegments::LineSegments(const geometry::LineSet& set, const ViewFrame& frame,
                           const LineSegments* before)
    : set_(set) {
  const std::size_t count = set.segment_count();
  if (count >= std::size_t(1) << 31 || set.positions.size() >= std::size_t(1) << 32)
    throw InputError(fmt::format("{} segments of lines; accepted: fewer than 2^31", count));
  first_points_.reserve(count);
  for (std::size_t k = 0; k < set.line_count(); ++k)
    for (std::uint64_t i = set.offsets[k]; i + 1 < set.offsets[k + 1]; ++i)
      first_points_.push_back(static_cast<std::uint32_t>(i));
  if (before && before->groups_->segments() == count)
    groups_ = before->groups_;
  else
    groups_ = std::make_shared<const SegmentGroups>(set, packet_width / frame.units_per_length());
}

std::uint32_t LineSegments::line(std::uint32_t segment) const {
  const auto next =
      std::upper_bound(set_.offsets.begin(), set_.offsets.end(), first_points_[segment]);
  return static_cast<std::uint32_t>(next - set_.offsets.begin() - 1);
}

/// Directions depend on the segment's ends and the nearest points of the line that lie elsewhere.
Vec3 LineSegments::direction(std::uint32_t segment, double along) const {
  const auto& points = set_.positions;
  const auto joined = [this](std::uint32_t s) {
    return s + 1 < count() && first_points_[s + 1] == first_points_[s] + 1;
  };
  const std::uint32_t i = first_points_[segment];
  std::uint32_t first = segment, last = segment;
  while (first > 0 && joined(first - 1) && points[first_points_[first]] == points[i]) --first;
  while (joined(last) && points[first_points_[last] + 1] == points[i + 1]) ++last;
  const std::uint32_t begin = first_points_[first], end = first_points_[last] + 2;
  const std::span<const Vec3> around(&points[begin], end - begin);
  return (1 - along) * unit(scene::line_direction(around, i - begin)) +
         along * unit(scene::line_direction(around, i + 1 - begin));
}

}  // namespace pellucid::groundtruth
