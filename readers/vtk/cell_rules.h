// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

#include "core/files/blocks.h"

namespace pellucid::readers {

/// The cells of a group as VTK keeps them: cell i has the points connectivity[offsets[i]] up to
/// connectivity[offsets[i + 1]].
struct CellGroup {
  std::span<const std::int64_t> offsets, connectivity;

  std::int64_t count() const { return std::int64_t(offsets.size()) - 1; }
  std::int64_t points_of(std::int64_t cell) const {
    return offsets[std::size_t(cell) + 1] - offsets[std::size_t(cell)];
  }
};

/// Throws BlockError unless offsets ascend from 0 to the connectivity's length and every index is
/// one of `point_count` points.
void check_cells(const CellGroup& cells, std::int64_t point_count);

/// Throws BlockError unless there is one known type per cell and each cell has the number of points
/// that its type wants. Polyhedra are left to check_polyhedra().
void check_types(std::span<const std::uint8_t> types, const CellGroup& cells);

/// Throws BlockError unless each polyhedron has a place in `faces`, from where the number of its
/// faces and their numbers of points and indices stay inside `faces` and `point_count`.
void check_polyhedra(std::span<const std::uint8_t> types, std::span<const std::int64_t> faces,
                     std::span<const std::int64_t> locations, std::int64_t point_count);

}  // namespace pellucid::readers
