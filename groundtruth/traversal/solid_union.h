// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "groundtruth/rays/crossing.h"

namespace pellucid::groundtruth {

/// A PartCrossing is a crossing with the solid that its part belongs to.
struct PartCrossing {
  std::uint32_t solid;
  Crossing crossing;
};

/// Appends the crossings of a ray with solids, given those with their parts, an entry (v < 0) and
/// an exit for every part that it meets: where the ray goes from no part of a solid into one, and
/// from its last part out. Touching parts are one. Sorts `parts`.
void append_union(std::vector<PartCrossing>& parts, std::vector<Crossing>& crossings);

}  // namespace pellucid::groundtruth
