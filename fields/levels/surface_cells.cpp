// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/levels/surface_cells.h"

#include <algorithm>

#include "core/parallel.h"
#include "fields/levels/level_boxes.h"

namespace pellucid::fields {
namespace {

/// Without touching its faces.
bool within(const Box3& part, const Box3& whole) {
  return glm::all(glm::greaterThan(part.min, whole.min)) &&
         glm::all(glm::lessThan(part.max, whole.max));
}

/// Smallest and largest sample.
struct Range {
  float low = std::numeric_limits<float>::infinity();
  float high = -std::numeric_limits<float>::infinity();

  /// Samples of the lattice cells from `first` to `last`, both included.
  void extend(const ScalarLevel& level, const LatticeCell& first, const LatticeCell& last) {
    const auto begin = [&](int axis) { return std::max(first.low[axis], 0); };
    const auto end = [&](int axis) { return std::min(last.low[axis] + 2, level.size[axis]); };
    for (int k = begin(2); k < end(2); ++k)
      for (int j = begin(1); j < end(1); ++j)
        for (int i = begin(0); i < end(0); ++i) {
          const float sample = level.at(i, j, k);
          low = std::min(low, sample);
          high = std::max(high, sample);
        }
  }
};

class CellPicker {
 public:
  CellPicker(const LevelField& field, double value)
      : field_(field), value_(field.scale().kept(value)) {}

  bool picks(const LatticeCell& cell) const {
    const Box3 box = cell_box(field_, cell);
    for (std::uint32_t finer = 0; finer < cell.level; ++finer)
      if (is_inside(box, field_.domain(finer))) return false;
    Range range;
    range.extend(field_.levels()[cell.level], cell, cell);
    // Where `trilinear` jumps it may cross the value on the region's faces, and rounding says to
    // which side a point on one belongs: the other levels' samples count there, too.
    const Box3& region = field_.region(cell.level).alone;
    const bool jumps = field_.reconstruction().kind == Reconstruction::trilinear;
    const bool alone = jumps ? within(box, region) : is_inside(box, region);
    const std::size_t count = alone ? cell.level : field_.levels().size();
    const Box3 around = with_rounding(field_, box);
    for (std::uint32_t other = 0; other < count; ++other)
      if (other != cell.level && touch(around, field_.region(other).support))
        range.extend(field_.levels()[other], field_.cell_at(other, box.min),
                     field_.cell_at(other, box.max));
    return range.low <= value_ && value_ <= range.high;
  }

 private:
  const LevelField& field_;
  double value_;  // as samples are kept
};

}  // namespace

Box3 cell_box(const LevelField& field, const LatticeCell& cell) {
  const ScalarLevel& level = field.levels()[cell.level];
  const Vec3 low(cell.low[0], cell.low[1], cell.low[2]);
  const Box3 domain = field.domain(cell.level);
  return {glm::max(level.world(low), domain.min), glm::min(level.world(low + 1.0), domain.max)};
}

std::vector<LatticeCell> surface_cells(const LevelField& field, double value) {
  const CellPicker picker(field, value);
  std::vector<LatticeCell> cells;
  for (std::uint32_t level = 0; level < field.levels().size(); ++level) {
    const Box3 domain = field.domain(level);
    const auto first = field.cell_at(level, domain.min).low;
    const auto last = field.cell_at(level, domain.max).low;
    std::vector<std::vector<LatticeCell>> slices(std::size_t(last[2] - first[2] + 1));
    parallel_for(first[2], last[2] + 1, [&](int k) {
      for (int j = first[1]; j <= last[1]; ++j)
        for (int i = first[0]; i <= last[0]; ++i)
          if (const LatticeCell cell{level, {i, j, k}}; picker.picks(cell))
            slices[std::size_t(k - first[2])].push_back(cell);
    });
    for (const auto& slice : slices) cells.insert(cells.end(), slice.begin(), slice.end());
  }
  return cells;
}

}  // namespace pellucid::fields
