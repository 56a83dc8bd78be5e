// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkDataSet.h>
#include <vtkType.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/vec.h"

namespace pellucid::fields {

/// CellCorners are the types and points of all cells of an unstructured or a structured grid, by
/// number and without a call of VTK's, which has to outlive them and not to change.
class CellCorners {
 public:
  /// The numbers of a cell's points, in VTK's order.
  using Numbers = std::span<const vtkTypeInt64>;

  explicit CellCorners(vtkDataSet& cells);
  CellCorners(const CellCorners&) = delete;
  CellCorners& operator=(const CellCorners&) = delete;

  std::size_t cells() const { return cells_; }
  /// VTK's number of the cell's type.
  int type(std::size_t cell) const { return types_.empty() ? hexahedron : types_[cell]; }
  /// Returns the numbers of a cell's points. Those of a structured grid, which has them nowhere,
  /// are put into `eight`.
  Numbers points(std::size_t cell, std::array<vtkTypeInt64, 8>& eight) const {
    if (!types_.empty())
      return points_.subspan(std::size_t(ends_[cell]), std::size_t(ends_[cell + 1] - ends_[cell]));
    compute(cell, eight);
    return eight;
  }
  /// In world units.
  const Vec3& place(vtkTypeInt64 point) const { return places_[std::size_t(point)]; }
  /// Returns the box of the cell's points, in world units.
  Box3 box(std::size_t cell) const;

 private:
  void compute(std::size_t cell, std::array<vtkTypeInt64, 8>& numbers) const;

  static constexpr int hexahedron = 12;

  std::size_t cells_;
  std::vector<Vec3> places_;
  std::vector<std::uint8_t> types_;       // none of a structured grid
  std::span<const vtkTypeInt64> ends_;    // where a cell's points begin and end in `points_`
  std::span<const vtkTypeInt64> points_;  // of all cells
  std::vector<vtkTypeInt64> own_ends_, own_points_;  // empty where the grid's own serve
  std::array<vtkTypeInt64, 3> dimensions_{};         // points of a structured grid along its axes
};

}  // namespace pellucid::fields
