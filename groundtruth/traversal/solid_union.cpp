// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/traversal/solid_union.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace pellucid::groundtruth {
namespace {

/// Solid by solid, front to back; entries first, so that touching parts overlap.
bool comes_before(const PartCrossing& p, const PartCrossing& q) {
  const auto key = [](const PartCrossing& part) {
    const Crossing& c = part.crossing;
    return std::tuple(c.object, part.solid, c.depth, !std::signbit(c.v), c.primitive);
  };
  return key(p) < key(q);
}

}  // namespace

void append_union(std::vector<PartCrossing>& parts, std::vector<Crossing>& crossings) {
  std::sort(parts.begin(), parts.end(), comes_before);
  int inside = 0;  // of how many parts; back to 0 after each solid
  for (const PartCrossing& part : parts) {
    const bool enters = std::signbit(part.crossing.v);
    if (enters ? inside == 0 : inside == 1) crossings.push_back(part.crossing);
    inside += enters ? 1 : -1;
  }
}

}  // namespace pellucid::groundtruth
