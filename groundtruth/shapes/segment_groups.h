// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/line_set.h"

namespace pellucid::groundtruth {

/// SegmentGroups deal the segments of lines, counted from line to line, to groups that follow each
/// other on a line, a box of the hierarchy each. Where segments are short, as those of stream lines
/// are, the hierarchy is a fraction as large as one over segments, sooner built and sooner walked.
class SegmentGroups {
 public:
  /// A group goes on as long as its segments together are no longer than `longest`, in world units,
  /// and no more than eight.
  SegmentGroups(const geometry::LineSet& set, double longest);

  std::uint32_t count() const { return std::uint32_t(begins_.size() - 1); }
  std::uint32_t segments() const { return begins_.back(); }
  /// Returns a group's first segment, and the one behind its last.
  ///@{
  std::uint32_t begin(std::uint32_t group) const { return begins_[group]; }
  std::uint32_t end(std::uint32_t group) const { return begins_[group + 1]; }
  ///@}
  std::uint64_t bytes() const { return begins_.size() * sizeof(std::uint32_t); }

 private:
  std::vector<std::uint32_t> begins_;
};

}  // namespace pellucid::groundtruth
