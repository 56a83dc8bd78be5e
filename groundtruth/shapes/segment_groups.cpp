// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/shapes/segment_groups.h"

namespace pellucid::groundtruth {

SegmentGroups::SegmentGroups(const geometry::LineSet& set, double longest) {
  constexpr std::uint32_t most = 8;
  std::uint32_t segment = 0;
  for (std::size_t k = 0; k < set.line_count(); ++k) {
    double length = 0;  // of the group so far
    bool begins = true;
    for (std::uint64_t i = set.offsets[k]; i + 1 < set.offsets[k + 1]; ++i, ++segment) {
      const double own = glm::distance(set.positions[i], set.positions[i + 1]);
      if (begins || length + own > longest || segment - begins_.back() == most) {
        begins_.push_back(segment);
        length = 0;
      }
      begins = false;
      length += own;
    }
  }
  begins_.push_back(segment);
}

}  // namespace pellucid::groundtruth
