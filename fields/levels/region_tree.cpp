// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/levels/region_tree.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace pellucid::fields {
namespace {

struct Split {
  int axis;
  double plane;
  double off_center;  // of the box, as a fraction of its side
};

bool overlap(const Box3& a, const Box3& b) {
  for (int axis = 0; axis < 3; ++axis)
    if (!(a.min[axis] < b.max[axis] && b.min[axis] < a.max[axis])) return false;
  return true;
}

void consider(const Box3& box, const Box3& part, std::optional<Split>& best) {
  if (!overlap(box, part)) return;
  for (int axis = 0; axis < 3; ++axis)
    for (const double plane : {part.min[axis], part.max[axis]}) {
      if (!(box.min[axis] < plane && plane < box.max[axis])) continue;
      const double off = std::abs(plane - box.center()[axis]) / (box.max[axis] - box.min[axis]);
      if (!best || off < best->off_center) best = {axis, plane, off};
    }
}

}  // namespace

RegionTree::RegionTree(std::span<const LevelRegion> regions) {
  Box3 box;
  for (const LevelRegion& region : regions) {
    box.extend(region.support.min);
    box.extend(region.support.max);
  }
  build(box, regions);
}

std::uint32_t RegionTree::build(const Box3& box, std::span<const LevelRegion> regions) {
  std::optional<Split> best;
  for (const LevelRegion& region : regions) {
    consider(box, region.support, best);
    consider(box, region.alone, best);
  }
  if (!best) return add_leaf(box.center(), regions);
  const auto index = std::uint32_t(nodes_.size());
  nodes_.push_back({best->axis, best->plane});
  Box3 below = box, above = box;
  below.max[best->axis] = above.min[best->axis] = best->plane;
  const std::uint32_t a = build(below, regions), b = build(above, regions);
  nodes_[index].a = a;
  nodes_[index].b = b;
  return index;
}

std::uint32_t RegionTree::add_leaf(const Vec3& center, std::span<const LevelRegion> regions) {
  const auto first = std::uint32_t(levels_.size());
  for (std::uint32_t level = 0; level < regions.size(); ++level) {
    if (!regions[level].support.contains(center)) continue;
    levels_.push_back(level);
    if (regions[level].alone.contains(center)) break;
  }
  nodes_.push_back({-1, 0, first, std::uint32_t(levels_.size()) - first});
  return std::uint32_t(nodes_.size() - 1);
}

std::span<const std::uint32_t> RegionTree::levels_at(const Vec3& x) const {
  const Node* node = nodes_.data();
  while (node->axis >= 0) node = &nodes_[x[node->axis] < node->plane ? node->a : node->b];
  return std::span(levels_).subspan(node->a, node->b);
}

void RegionTree::append_parts(const Vec3& start, const Vec3& direction, double begin, double end,
                              std::vector<Part>& parts) const {
  append_parts(nodes_.front(), start, direction, begin, end, parts);
}

void RegionTree::append_parts(const Node& node, const Vec3& start, const Vec3& direction,
                              double begin, double end, std::vector<Part>& parts) const {
  if (!(begin < end)) return;
  if (node.axis < 0) {
    const auto levels = std::span(levels_).subspan(node.a, node.b);
    const bool goes_on = !parts.empty() && parts.back().end == begin &&
                         std::ranges::equal(parts.back().levels, levels);
    if (goes_on) parts.back().end = end;
    if (!goes_on && !levels.empty()) parts.push_back({begin, end, levels});
    return;
  }
  const Node &below = nodes_[node.a], &above = nodes_[node.b];
  const double from = start[node.axis], slope = direction[node.axis];
  if (slope == 0)
    return append_parts(from < node.plane ? below : above, start, direction, begin, end, parts);
  const double at = (node.plane - from) / slope;
  append_parts(slope > 0 ? below : above, start, direction, begin, std::min(end, at), parts);
  append_parts(slope > 0 ? above : below, start, direction, std::max(begin, at), end, parts);
}

std::size_t RegionTree::most_levels() const {
  std::uint32_t most = 0;
  for (const Node& node : nodes_)
    if (node.axis < 0) most = std::max(most, node.b);
  return most;
}

}  // namespace pellucid::fields
