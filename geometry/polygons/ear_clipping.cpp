// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/polygons/ear_clipping.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace pellucid::geometry {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// Corners by the cell of a square grid in which they lie. Corners are taken out, never moved.
class CornerGrid {
 public:
  explicit CornerGrid(std::span<const Vec2> places)
      : places_(places),
        width_(std::clamp(int(std::sqrt(double(places.size()))), 1, 1024)),
        cells_(std::size_t(width_) * std::size_t(width_)) {}

  void add(std::uint32_t corner) { cell_of(places_[corner]).push_back(corner); }
  void remove(std::uint32_t corner) { std::erase(cell_of(places_[corner]), corner); }

  /// Says whether `holds` is true of any corner in the cells that the box meets.
  template <class Holds>
  bool any_in(const Vec2& low, const Vec2& high, const Holds& holds) const {
    for (int row = index(low.y); row <= index(high.y); ++row)
      for (int column = index(low.x); column <= index(high.x); ++column)
        for (const std::uint32_t corner : cells_[cell(row, column)])
          if (holds(corner)) return true;
    return false;
  }

 private:
  int index(double x) const { return std::clamp(int((x + 1) * 0.5 * width_), 0, width_ - 1); }
  std::size_t cell(int row, int column) const { return std::size_t(row * width_ + column); }
  std::vector<std::uint32_t>& cell_of(const Vec2& x) {
    return cells_[cell(index(x.y), index(x.x))];
  }

  std::span<const Vec2> places_;
  int width_;
  std::vector<std::vector<std::uint32_t>> cells_;
};

/// What is left of the polygon: a ring of its corners.
class Ring {
 public:
  Ring(std::span<const Vec2> places, double rounding)
      : places_(places), grid_(places), rounding_(rounding), size_(std::uint32_t(places.size())) {
    for (std::uint32_t i = 0; i < size_; ++i) {
      next_.push_back(i + 1 < size_ ? i + 1 : 0);
      previous_.push_back(i > 0 ? i - 1 : size_ - 1);
    }
    for (std::uint32_t i = 0; i < size_; ++i)
      if (blocking_.push_back(turn_at(i) <= 0), blocking_[i]) grid_.add(i);
  }

  std::uint32_t size() const { return size_; }
  std::uint32_t next(std::uint32_t i) const { return next_[i]; }
  Triangle triangle(std::uint32_t i) const { return {previous_[i], i, next_[i]}; }

  bool is_ear(std::uint32_t i) const {
    if (turn_at(i) <= 0 || is_spike(previous_[i]) || is_spike(next_[i])) return false;
    const Vec2 a = places_[previous_[i]], b = places_[i], c = places_[next_[i]];
    return !grid_.any_in(glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c)),
                         [&](std::uint32_t k) {
                           const Vec2& x = places_[k];
                           return turn(a, b, x) >= 0 && turn(b, c, x) >= 0 && turn(c, a, x) >= 0 &&
                                  x != a && x != b && x != c;
                         });
  }

  /// Says whether the ring runs back from the corner to where it came from, or stays at its place.
  bool is_spike(std::uint32_t i) const {
    const Vec2 &a = places_[previous_[i]], &b = places_[i], &c = places_[next_[i]];
    return turn_at(i) == 0 && glm::dot(a - b, c - b) >= 0;
  }

  /// The corner at which the ring turns least, if that is as good as none: it can go without a
  /// change of what the ring covers.
  std::optional<std::uint32_t> straight_corner(std::uint32_t from) const {
    std::uint32_t best = from;
    for (std::uint32_t i = next_[from]; i != from; i = next_[i])
      if (std::abs(turn_at(i)) < std::abs(turn_at(best))) best = i;
    if (std::abs(turn_at(best)) > rounding_) return std::nullopt;
    return best;
  }

  void remove(std::uint32_t i) {
    const std::uint32_t before = previous_[i], after = next_[i];
    if (blocking_[i]) grid_.remove(i);
    next_[before] = after;
    previous_[after] = before;
    --size_;
    for (const std::uint32_t k : {before, after}) update(k);
  }

 private:
  double turn_at(std::uint32_t i) const {
    return turn(places_[previous_[i]], places_[i], places_[next_[i]]);
  }
  void update(std::uint32_t i) {
    const bool blocks = turn_at(i) <= 0;
    if (blocks && !blocking_[i]) grid_.add(i);
    if (!blocks && blocking_[i]) grid_.remove(i);
    blocking_[i] = blocks;
  }

  std::span<const Vec2> places_;
  CornerGrid grid_;  // of the corners that do not turn to the left
  double rounding_;
  std::uint32_t size_;
  std::vector<std::uint32_t> next_, previous_;
  std::vector<bool> blocking_;
};

}  // namespace

// Spikes go first: an ear beside one would have the spike's other side in it. The corner after an
// ear's is passed over, so that ears are cut all around the polygon and the triangles do not all
// meet in one corner.
std::vector<Triangle> clip_ears(std::span<const Vec2> polygon, double rounding) {
  std::vector<Triangle> triangles;
  Ring ring(polygon, rounding);
  const auto clip = [&](std::uint32_t corner) {
    const auto [before, cut, after] = ring.triangle(corner);
    triangles.push_back({before, cut, after});
    const std::uint32_t beyond = ring.next(after);
    ring.remove(cut);
    return beyond;
  };
  std::uint32_t at = 0;
  for (std::uint32_t tried = 0; ring.size() > 3;) {
    if (ring.is_spike(at) || ring.is_ear(at)) {
      at = clip(at);
      tried = 0;
    } else if (++tried < ring.size()) {
      at = ring.next(at);
    } else if (const auto straight = ring.straight_corner(at)) {
      at = clip(*straight);
      tried = 0;
    } else {
      return {};
    }
  }
  triangles.push_back(ring.triangle(at));
  const auto& [a, b, c] = triangles.back();
  if (turn(polygon[a], polygon[b], polygon[c]) < -rounding) return {};
  return triangles;
}

}  // namespace pellucid::geometry
