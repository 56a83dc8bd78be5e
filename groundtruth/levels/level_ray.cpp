// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/levels/level_ray.h"

#include <algorithm>
#include <cmath>

#include "fields/levels/surface_cells.h"
#include "groundtruth/levels/ray_polynomial.h"

namespace pellucid::groundtruth {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// From `begin` on, up to but without `end`.
struct Interval {
  double begin = 0, end = infinity;
  bool empty() const { return !(begin < end); }
};

/// How far an end of a polynomial may lie from the shared evaluation there by rounding alone, as a
/// fraction of the largest coefficient: lattice coordinates up to 1e4 carry 1e-12 each. More is a
/// jump of the reconstruction.
constexpr double rounding = 1e-10;

/// Below the value, by nothing else.
constexpr double outside = -std::numeric_limits<double>::min();

class CellRay {
 public:
  /// `scratch` saves an allocation per cell.
  CellRay(const fields::LevelField& field, double value, const fields::LatticeCell& cell,
          const WorldRay& ray, std::vector<double>& at, std::array<std::vector<double>, 2>& scratch)
      : field_(field),
        value_(value),
        cell_(cell),
        ray_(ray),
        at_(at),
        cuts_(scratch[0]),
        roots_(scratch[1]) {}

  void append() {
    const Interval all = within(cell_.level, cell_.low);
    if (all.empty()) return;
    cuts_.assign({all.begin, all.end});
    for (std::uint32_t other = 0; other < field_.levels().size(); ++other)
      if (other != cell_.level) cut(other, all);
    std::sort(cuts_.begin(), cuts_.end());
    for (std::size_t i = 0; i + 1 < cuts_.size(); ++i)
      if (const Interval part{cuts_[i], cuts_[i + 1]}; !part.empty() && finest_in(part))
        solve(part);
  }

 private:
  /// Where the ray meets a plane: the same number whoever asks.
  double plane(int axis, double position) const {
    return (position - ray_.start[axis]) / ray_.direction[axis];
  }
  double lattice_plane(std::uint32_t level, int axis, int index) const {
    const fields::ScalarLevel& l = field_.levels()[level];
    return plane(axis, l.origin[axis] + l.width * index);
  }

  /// Narrows `t` to the part between two planes across an axis, the lower one included.
  void clip(int axis, double low, double high, Interval& t) const {
    if (ray_.direction[axis] == 0) {
      if (!(low <= ray_.start[axis] && ray_.start[axis] < high)) t.end = t.begin;
      return;
    }
    const auto [first, last] = std::minmax({plane(axis, low), plane(axis, high)});
    t = {std::max(t.begin, first), std::min(t.end, last)};
  }
  void clip(const Box3& box, Interval& t) const {
    for (int axis = 0; axis < 3; ++axis) clip(axis, box.min[axis], box.max[axis], t);
  }

  /// The part of the ray within a lattice cell and its level's domain.
  Interval within(std::uint32_t level, const std::array<int, 3>& low) const {
    const fields::ScalarLevel& l = field_.levels()[level];
    Interval t;
    clip(field_.domain(level), t);
    for (int axis = 0; axis < 3; ++axis)
      clip(axis, l.origin[axis] + l.width * low[axis], l.origin[axis] + l.width * (low[axis] + 1),
           t);
    return t;
  }

  /// Adds the planes at which another level's part of the reconstruction changes.
  void cut(std::uint32_t other, const Interval& all) {
    const auto add = [&](double t) {
      if (all.begin < t && t < all.end) cuts_.push_back(t);
    };
    const Box3 domain = field_.domain(other), support = field_.region(other).support;
    const Vec3 a = ray_.at(all.begin), b = ray_.at(all.end);
    if (glm::any(glm::lessThan(glm::max(a, b), support.min)) ||
        glm::any(glm::greaterThan(glm::min(a, b), support.max)))
      return;
    const auto low = field_.cell_at(other, glm::min(a, b)).low;
    const auto high = field_.cell_at(other, glm::max(a, b)).low;
    for (int axis = 0; axis < 3; ++axis) {
      if (ray_.direction[axis] == 0) continue;
      for (const double face :
           {domain.min[axis], domain.max[axis], support.min[axis], support.max[axis]})
        add(plane(axis, face));
      for (int i = low[axis]; i <= high[axis] + 1; ++i) add(lattice_plane(other, axis, i));
    }
  }

  /// Whether no finer level's domain holds the part; its faces do not cut it.
  bool finest_in(const Interval& part) const {
    for (std::uint32_t finer = 0; finer < cell_.level; ++finer) {
      Interval t;
      clip(field_.domain(finer), t);
      if (t.begin <= part.begin && part.end <= t.end) return false;
    }
    return true;
  }

  /// The numerator at one point of the ray, by the cells that the point alone decides.
  std::optional<double> numerator_at(double t) const {
    const Vec3 x = ray_.at(t);
    fields::LevelField::Cells cells;
    const std::size_t count = field_.cells_at(x, cells);
    if (count == 0) return std::nullopt;
    const double sum =
        field_.sum<double>(std::span(cells).first(count), {x.x, x.y, x.z}, value_).sum;
    // 0 is inside, but where the surface is only touched on a face nothing is crossed.
    return sum == 0 && is_outside(t, -1) && is_outside(t, 1) ? outside : sum;
  }

  /// Whether the field is below the value on the short part of the ray next to t: from both of a
  /// face's cells the same part.
  bool is_outside(double t, int towards) const {
    const double width = field_.levels().front().width / glm::length(ray_.direction);
    const double beside = t + towards * 0x1p-10 * width;
    fields::LevelField::Cells cells;
    const std::size_t count = field_.cells_at(ray_.at(0.5 * (t + beside)), cells);
    if (count == 0) return false;
    const RayPolynomial p = numerator(std::span(cells).first(count), t, beside).sum;
    return p.first_beyond(rounding * p.largest_coefficient()) < 0;
  }

  fields::LevelSum<RayPolynomial> numerator(std::span<const fields::LatticeCell> cells, double from,
                                            double to) const {
    const Vec3 a = ray_.at(from), b = ray_.at(to);
    return field_.sum<RayPolynomial>(cells, {{{a.x, b.x}, {a.y, b.y}, {a.z, b.z}}}, value_);
  }

  void solve(const Interval& part) {
    fields::LevelField::Cells cells;
    const std::size_t count = field_.cells_at(ray_.at(0.5 * (part.begin + part.end)), cells);
    if (count == 0) return;  // a part of rounding's length beyond the outermost face
    auto [p, weight] = numerator(std::span(cells).first(count), part.begin, part.end);
    // Where no hat reaches there is no value. At an end of that the numerator is 0 as well, and the
    // value's sign is that next to it.
    const double least_weight = rounding * weight.largest_coefficient();
    if (weight.largest_coefficient() <= rounding) return;
    const double tolerance = rounding * p.largest_coefficient();
    const bool begins = weight.begin() > least_weight, ends = weight.end() > least_weight;
    if (!begins) p.set_begin(p.first_beyond(tolerance));
    if (!ends) p.set_end(p.last_beyond(tolerance));
    const double begin = begins ? numerator_at(part.begin).value_or(p.begin()) : p.begin();
    const double end = ends ? numerator_at(part.end).value_or(p.end()) : p.end();
    if (std::abs(begin - p.begin()) <= tolerance) p.set_begin(begin);
    if (std::abs(end - p.end()) <= tolerance) p.set_end(end);
    if ((begin < 0) != (p.begin() < 0)) at_.push_back(part.begin);
    roots_.clear();
    append_sign_changes(p, roots_);
    for (const double root : roots_) at_.push_back(part.begin + root * (part.end - part.begin));
    if ((end < 0) != (p.end() < 0)) at_.push_back(part.end);
  }

  const fields::LevelField& field_;
  double value_;
  const fields::LatticeCell& cell_;
  const WorldRay& ray_;
  std::vector<double>& at_;
  std::vector<double>& cuts_;
  std::vector<double>& roots_;
};

}  // namespace

void append_level_crossings(const fields::LevelField& field, double value,
                            const fields::LatticeCell& cell, const WorldRay& ray,
                            std::vector<double>& at) {
  thread_local std::array<std::vector<double>, 2> scratch;
  CellRay(field, value, cell, ray, at, scratch).append();
}

}  // namespace pellucid::groundtruth
