// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/levels/level_blocks.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <tuple>

namespace pellucid::fields {
namespace {

using Index = std::array<int, 3>;

// Of a cell: origins are written in decimals, or made by adding widths up.
constexpr double rounding = 1e-6;

/// Where the first sample of b lies on the lattice of a; nothing when it is on none of its places.
template <class T>
std::optional<Index> offset(const Level<T>& a, const Level<T>& b) {
  if (!(std::abs(a.width - b.width) <= rounding / 1e3 * a.width)) return std::nullopt;
  Index at{};
  for (int axis = 0; axis < 3; ++axis) {
    const double cells = (b.origin[axis] - a.origin[axis]) / a.width, whole = std::round(cells);
    if (!(std::abs(cells - whole) <= rounding) || !(std::abs(whole) < 1e9)) return std::nullopt;
    at[std::size_t(axis)] = int(whole);
  }
  return at;
}

/// The axis along which b goes on where a ends, or overlaps its end, if they are as wide across.
template <class T>
std::optional<std::size_t> joint(const Level<T>& a, const Level<T>& b, const Index& at) {
  std::optional<std::size_t> along;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (at[axis] == 0 && a.size[axis] == b.size[axis]) continue;
    const bool goes_on =
        at[axis] > 0 && at[axis] <= a.size[axis] && at[axis] + b.size[axis] > a.size[axis];
    if (along || !goes_on) return std::nullopt;
    along = axis;
  }
  return along;
}

template <class Visit>
void for_each_sample(const Index& size, const Visit& visit) {
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i) visit(i, j, k);
}

template <class T>
void copy_to(Level<T>& whole, const Level<T>& part, const Index& at) {
  for_each_sample(part.size, [&](int i, int j, int k) {
    whole.samples[whole.index(i + at[0], j + at[1], k + at[2])] = part.at(i, j, k);
  });
}

/// a and b, which overlap from layer at[axis] of a on, in one; nothing when they differ there.
template <class T>
std::optional<Level<T>> joined(const Level<T>& a, const Level<T>& b, const Index& at,
                               std::size_t axis) {
  bool equal = true;
  Index shared = a.size;
  shared[axis] -= at[axis];
  for_each_sample(shared, [&](int i, int j, int k) {
    equal = equal && a.at(i + at[0], j + at[1], k + at[2]) == b.at(i, j, k);
  });
  if (!equal) return std::nullopt;
  Level<T> whole{a.origin, a.width, a.size, {}};
  whole.size[axis] = at[axis] + b.size[axis];
  whole.samples.resize(std::size_t(whole.size[0]) * std::size_t(whole.size[1]) *
                       std::size_t(whole.size[2]));
  copy_to(whole, a, {0, 0, 0});
  copy_to(whole, b, at);
  return whole;
}

template <class T>
std::optional<Level<T>> joined(const Level<T>& a, const Level<T>& b) {
  const auto at = offset(a, b);
  if (!at) return std::nullopt;
  const auto axis = joint(a, b, *at);
  return axis ? joined(a, b, *at, *axis) : std::nullopt;
}

/// Joins to level `a` the first other one that goes on where it ends; along x before y before z, so
/// that rows become slabs. Returns whether there is one; `a` then stands for both.
template <class T>
bool join_another(std::size_t& a, std::vector<Level<T>>& levels) {
  for (std::size_t b = 0; b < levels.size(); ++b) {
    if (a == b) continue;
    auto whole = joined(levels[a], levels[b]);
    if (!whole) continue;
    levels[a] = std::move(*whole);
    levels.erase(levels.begin() + std::ptrdiff_t(b));
    if (b < a) --a;
    return true;
  }
  return false;
}

/// What has grown may be what an earlier one goes on with: all are asked again until none is.
template <class T>
std::vector<Level<T>> join_all(std::vector<Level<T>> levels) {
  for (bool any = true; any;) {
    any = false;
    for (std::size_t a = 0; a < levels.size(); ++a)
      while (join_another(a, levels)) any = true;
  }
  return levels;
}

/// Blocks of one lattice around one of them, which is the first; indices are its own.
class Neighbourhood {
 public:
  Neighbourhood(const std::vector<ScalarLevel>& levels, std::size_t first) {
    add(levels[first], {0, 0, 0});
    for (std::size_t i = 0; i < levels.size(); ++i)
      if (const auto at = offset(levels[first], levels[i]);
          i != first && at && touches(levels[first], levels[i], *at))
        add(levels[i], *at);
  }

  std::optional<float> sample(const Index& at) const {
    for (const auto& [level, offset] : blocks_)
      if (holds(*level, offset, at, 0))
        return level->at(at[0] - offset[0], at[1] - offset[1], at[2] - offset[2]);
    return std::nullopt;
  }

  /// Whether the cell above that sample has all its corners, but in no one block.
  bool is_between(const Index& cell) const {
    for (const auto& [level, offset] : blocks_)
      if (holds(*level, offset, cell, 1)) return false;
    for (int corner = 0; corner < 8; ++corner)
      if (!sample({cell[0] + (corner & 1), cell[1] + (corner >> 1 & 1), cell[2] + (corner >> 2)}))
        return false;
    return true;
  }
  bool has_neighbours() const { return blocks_.size() > 1; }

 private:
  struct Block {
    const ScalarLevel* level;
    Index offset;
  };

  void add(const ScalarLevel& level, const Index& offset) { blocks_.push_back({&level, offset}); }

  /// Whether a and b have cells between them, or overlap.
  static bool touches(const ScalarLevel& a, const ScalarLevel& b, const Index& at) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (at[axis] > a.size[axis] || at[axis] + b.size[axis] < 0) return false;
    return true;
  }
  /// Whether sample `at`, and the `further` ones above it along every axis, are the block's.
  static bool holds(const ScalarLevel& level, const Index& offset, const Index& at, int further) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (at[axis] < offset[axis] || at[axis] + further >= offset[axis] + level.size[axis])
        return false;
    return true;
  }

  std::vector<Block> blocks_;
};

/// The cells between blocks that lie at one of them.
std::set<Index> cells_between(const Neighbourhood& near, const Index& size) {
  std::set<Index> cells;
  for (int k = -1; k < size[2]; ++k)
    for (int j = -1; j < size[1]; ++j)
      for (int i = -1; i < size[0]; ++i) {
        const bool inner_row = j >= 0 && j < size[1] - 1 && k >= 0 && k < size[2] - 1;
        if (inner_row && i == 0) i = std::max(i, size[0] - 1);  // all within the block
        if (near.is_between({i, j, k})) cells.insert({i, j, k});
      }
  return cells;
}

/// Takes the largest box of cells that grows from the first along x, then y, then z.
Index take_box(std::set<Index>& cells, const Index& first) {
  Index size{1, 1, 1};
  const auto all = [&](const Index& extent, const auto& test) {
    for (int k = 0; k < extent[2]; ++k)
      for (int j = 0; j < extent[1]; ++j)
        for (int i = 0; i < extent[0]; ++i)
          if (!test(Index{first[0] + i, first[1] + j, first[2] + k})) return false;
    return true;
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (Index grown = size;
         ++grown[axis], all(grown, [&](const Index& cell) { return cells.contains(cell); });)
      size = grown;
  all(size, [&](const Index& cell) { return cells.erase(cell) > 0; });
  return size;
}

ScalarLevel seam(const ScalarLevel& block, const Neighbourhood& near, const Index& first,
                 const Index& cells) {
  ScalarLevel level{block.world(Vec3(first[0], first[1], first[2])),
                    block.width,
                    {cells[0] + 1, cells[1] + 1, cells[2] + 1},
                    {}};
  for_each_sample(level.size, [&](int i, int j, int k) {
    level.samples.push_back(near.sample({first[0] + i, first[1] + j, first[2] + k}).value_or(0));
  });
  return level;
}

}  // namespace

std::vector<ScalarLevel> joined_blocks(std::vector<ScalarLevel> levels) {
  return join_all(std::move(levels));
}
std::vector<VectorLevel> joined_blocks(std::vector<VectorLevel> levels) {
  return join_all(std::move(levels));
}
std::vector<DoubleVectorLevel> joined_blocks(std::vector<DoubleVectorLevel> levels) {
  return join_all(std::move(levels));
}

// Every block looks at the cells around it, also at those that a block before it has taken: they
// are part of a level by then.
void add_seams(std::vector<ScalarLevel>& levels) {
  const std::size_t blocks = levels.size();
  for (std::size_t i = 0; i < blocks; ++i) {
    std::vector<ScalarLevel> found;
    const Neighbourhood near(levels, i);
    if (!near.has_neighbours()) continue;
    std::set<Index> cells = cells_between(near, levels[i].size);
    while (!cells.empty()) {
      const Index first = *cells.begin();
      const Index size = take_box(cells, first);
      found.push_back(seam(levels[i], near, first, size));
    }
    std::ranges::move(found, std::back_inserter(levels));
  }
}

}  // namespace pellucid::fields
