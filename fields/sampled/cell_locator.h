// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/vec.h"

namespace pellucid::fields {

/// A CellLocator knows which cells' boxes may hold a place: by a grid of bins over all cells, in
/// which a bin of many is a grid of its own (Kalojanov, Billeter, Slusallek 2011, Two-Level Grids
/// for Ray Tracing on GPUs, to any depth), so that meshes that are fine in places are no slower.
class CellLocator {
 public:
  /// `box_of(i)` is the box of cell i, in world units; it is called by several threads, and some
  /// times for each cell. Boxes may be grown to forgive roundings. There may be 2^31 cells.
  CellLocator(std::size_t cells, const std::function<Box3(std::size_t)>& box_of);

  /// Returns numbers of cells in ascending order, all whose boxes hold x among them; none where x
  /// is not in the box of all.
  std::span<const std::uint32_t> cells_at(const Vec3& x) const;

 private:
  using Index = std::array<int, 3>;
  using Cells = std::vector<std::uint32_t>;

  /// Bins of one size over a box: of those along x, y and z bin (0, 0, 0) is number `first`.
  struct Grid {
    Vec3 low{0}, bins_per_unit{0};
    Index size{1, 1, 1};
    std::uint32_t first = 0;

    /// Clamped before it is an int, which holds no more than 2^31; what is no number is in bin 0.
    Index at(const Vec3& x) const {
      Index index;
      for (int axis = 0; axis < 3; ++axis) {
        const double bin = (x[axis] - low[axis]) * bins_per_unit[axis];
        index[std::size_t(axis)] =
            bin > 0 ? int(std::min(bin, double(size[std::size_t(axis)] - 1))) : 0;
      }
      return index;
    }
    std::uint32_t bin(const Index& at) const {
      return first + std::uint32_t(at[0] + size[0] * (at[1] + size[1] * at[2]));
    }
    std::uint32_t bins() const { return std::uint32_t(size[0] * size[1] * size[2]); }
  };
  /// A bin's cells in the list of all bins' cells, or the number of its own grid.
  struct Bin {
    static constexpr std::uint32_t is_grid = 0xffffffff;
    std::uint32_t first = 0, count = 0;
  };
  /// Grids within each other, from the first on.
  struct Tree {
    std::vector<Grid> grids;
    std::vector<Bin> bins;
    Cells lists;
  };
  class Builder;

  Box3 box_;
  Tree tree_;
};

}  // namespace pellucid::fields
