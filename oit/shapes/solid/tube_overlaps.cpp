// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/shapes/solid/tube_overlaps.h"

#include <algorithm>

namespace pellucid::oit {
namespace {

/// All within a reach of a box.
struct RoundBox {
  Box3 box;
  double reach = 0;
};

/// A part of a line that is straight, its radius linear.
struct Stretch {
  Vec3 a, b;
  double radius_a, radius_b;

  double length() const { return glm::length(b - a); }
  RoundBox bounds() const {
    return {{glm::min(a, b), glm::max(a, b)}, std::max(radius_a, radius_b)};
  }
};

bool may_overlap(const RoundBox& p, const RoundBox& q) {
  // Beyond the rounding of coordinates to the view frame, and of the shader's sums.
  const double reach = (p.reach + q.reach) * (1 + 1e-9);
  const Vec3 gap = glm::max(glm::max(p.box.min - q.box.max, q.box.min - p.box.max), Vec3(0));
  return glm::dot(gap, gap) <= reach * reach;
}

/// Whether two segments may overlap: they are halved, the longer one first, while what is around
/// what is left does.
bool may_meet(const Stretch& p, const Stretch& q, int halvings = 8) {
  if (!may_overlap(p.bounds(), q.bounds())) return false;
  if (halvings == 0) return true;
  if (p.length() < q.length()) return may_meet(q, p, halvings);
  const Vec3 middle = 0.5 * (p.a + p.b);
  const double radius = 0.5 * (p.radius_a + p.radius_b);
  return may_meet({p.a, middle, p.radius_a, radius}, q, halvings - 1) ||
         may_meet({middle, p.b, radius, p.radius_b}, q, halvings - 1);
}

/// The segments of a line in a binary tree: what follows each other is near each other.
class SegmentTree {
 public:
  SegmentTree(std::span<const Vec3> line, scene::RadiusSpan radius)
      : line_(line), radius_(radius), bounds_(4 * (line.size() - 1)) {
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

  Stretch segment(std::uint32_t i) const {
    return {line_[i], line_[i + 1], radius_.at(i), radius_.at(i + 1)};
  }

  const RoundBox& build(const Node& node) {
    RoundBox& bounds = bounds_[node.index];
    if (node.is_leaf()) return bounds = segment(node.first).bounds();
    for (const Node& half : {node.front(), node.back()}) {
      const RoundBox& part = build(half);
      bounds.box.extend(part.box.min);
      bounds.box.extend(part.box.max);
      bounds.reach = std::max(bounds.reach, part.reach);
    }
    return bounds;
  }

  template <class Visit>
  bool visit_pairs(const Node& node, const Visit& visit) const {
    return node.is_leaf() || (visit_pairs(node.front(), visit) && visit_pairs(node.back(), visit) &&
                              visit_pairs(node.front(), node.back(), visit));
  }

  template <class Visit>
  bool visit_pairs(const Node& p, const Node& q, const Visit& visit) const {
    if (!may_overlap(bounds_[p.index], bounds_[q.index])) return true;
    if (p.is_leaf() && q.is_leaf())
      return !may_meet(segment(p.first), segment(q.first)) || visit(p.first, q.first);
    if (q.is_leaf() || (!p.is_leaf() && p.last - p.first > q.last - q.first))
      return visit_pairs(p.front(), q, visit) && visit_pairs(p.back(), q, visit);
    return visit_pairs(p, q.front(), visit) && visit_pairs(p, q.back(), visit);
  }

  std::span<const Vec3> line_;
  scene::RadiusSpan radius_;
  std::vector<RoundBox> bounds_;
};

}  // namespace

std::vector<SegmentPair> overlapping_segments(std::span<const Vec3> line, scene::RadiusSpan radius,
                                              std::size_t most) {
  std::vector<SegmentPair> pairs;
  if (line.size() < 3) return pairs;
  SegmentTree(line, radius).visit_pairs([&](std::uint32_t p, std::uint32_t q) {
    pairs.push_back({p, q});
    return pairs.size() <= most;
  });
  return pairs;
}

}  // namespace pellucid::oit
