// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/shapes/tube_overlaps.h"

namespace pellucid::oit {
namespace {

Box3 box_around(const Vec3& a, const Vec3& b) { return {glm::min(a, b), glm::max(a, b)}; }

bool within(const Box3& p, const Box3& q, double reach) {
  const Vec3 gap = glm::max(glm::max(p.min - q.max, q.min - p.max), Vec3(0));
  return glm::dot(gap, gap) <= reach * reach;
}

/// Whether two segments may come within the reach: they are halved, the longer one first, while the
/// boxes around what is left do.
bool may_meet(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, double reach,
              int halvings = 8) {
  if (!within(box_around(a, b), box_around(c, d), reach)) return false;
  if (halvings == 0) return true;
  if (glm::length(b - a) < glm::length(d - c)) return may_meet(c, d, a, b, reach, halvings);
  const Vec3 middle = 0.5 * (a + b);
  return may_meet(a, middle, c, d, reach, halvings - 1) ||
         may_meet(middle, b, c, d, reach, halvings - 1);
}

/// The segments of a line in a binary tree: what follows each other is near each other.
class SegmentTree {
 public:
  SegmentTree(std::span<const Vec3> line, double reach)
      : line_(line), reach_(reach), boxes_(4 * (line.size() - 1)) {
    build(root());
  }

  /// Calls visit(segment, segment) for every pair, until it returns false.
  template <class Visit>
  void visit_pairs(const Visit& visit) const {
    visit_pairs(root(), visit);
  }

 private:
  /// Segments from `first` up to, and without, `last`.
  struct Node {
    std::size_t index;
    std::uint32_t first, last;

    bool is_leaf() const { return last - first == 1; }
    std::uint32_t middle() const { return first + (last - first) / 2; }
    Node front() const { return {2 * index + 1, first, middle()}; }
    Node back() const { return {2 * index + 2, middle(), last}; }
  };

  Node root() const { return {0, 0, std::uint32_t(line_.size() - 1)}; }

  const Box3& build(const Node& node) {
    Box3& box = boxes_[node.index];
    if (node.is_leaf()) return box = box_around(line_[node.first], line_[node.last]);
    for (const Node& half : {node.front(), node.back()}) {
      const Box3& part = build(half);
      box.extend(part.min);
      box.extend(part.max);
    }
    return box;
  }

  template <class Visit>
  bool visit_pairs(const Node& node, const Visit& visit) const {
    return node.is_leaf() || (visit_pairs(node.front(), visit) && visit_pairs(node.back(), visit) &&
                              visit_pairs(node.front(), node.back(), visit));
  }

  template <class Visit>
  bool visit_pairs(const Node& p, const Node& q, const Visit& visit) const {
    if (!within(boxes_[p.index], boxes_[q.index], reach_)) return true;
    if (p.is_leaf() && q.is_leaf())
      return !may_meet(line_[p.first], line_[p.last], line_[q.first], line_[q.last], reach_) ||
             visit(p.first, q.first);
    if (q.is_leaf() || (!p.is_leaf() && p.last - p.first > q.last - q.first))
      return visit_pairs(p.front(), q, visit) && visit_pairs(p.back(), q, visit);
    return visit_pairs(p, q.front(), visit) && visit_pairs(p, q.back(), visit);
  }

  std::span<const Vec3> line_;
  double reach_;
  std::vector<Box3> boxes_;
};

}  // namespace

std::vector<SegmentPair> overlapping_segments(std::span<const Vec3> line, double radius,
                                              std::size_t most) {
  std::vector<SegmentPair> pairs;
  if (line.size() < 3) return pairs;
  // Beyond the rounding of coordinates to the view frame, and of the shader's sums.
  const double reach = 2 * radius * (1 + 1e-9);
  SegmentTree(line, reach).visit_pairs([&](std::uint32_t p, std::uint32_t q) {
    pairs.push_back({p, q});
    return pairs.size() <= most;
  });
  return pairs;
}

}  // namespace pellucid::oit
