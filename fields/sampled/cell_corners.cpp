// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/sampled/cell_corners.h"

#include <vtkAOSDataArrayTemplate.h>
#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkStructuredGrid.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cassert>

namespace pellucid::fields {
namespace {

/// The numbers of an array where it has them, or a copy of them: VTK 9.1 keeps them one after
/// another, later versions need not.
std::span<const vtkTypeInt64> numbers_of(vtkDataArray* array, std::vector<vtkTypeInt64>& copy) {
  if (auto* numbers = vtkArrayDownCast<vtkAOSDataArrayTemplate<vtkTypeInt64>>(array))
    return {numbers->GetPointer(0), std::size_t(numbers->GetNumberOfValues())};
  copy.resize(std::size_t(array->GetNumberOfTuples()));
  for (std::size_t i = 0; i < copy.size(); ++i)
    copy[i] = vtkTypeInt64(array->GetComponent(vtkIdType(i), 0));
  return copy;
}

}  // namespace

CellCorners::CellCorners(vtkDataSet& cells) : cells_(std::size_t(cells.GetNumberOfCells())) {
  static_assert(hexahedron == VTK_HEXAHEDRON);
  places_.resize(std::size_t(cells.GetNumberOfPoints()));
  for (std::size_t i = 0; i < places_.size(); ++i) cells.GetPoint(vtkIdType(i), &places_[i].x);
  if (auto* structured = vtkStructuredGrid::SafeDownCast(&cells)) {
    int size[3];
    structured->GetDimensions(size);
    dimensions_ = {size[0], size[1], size[2]};
    return;
  }
  auto* grid = vtkUnstructuredGrid::SafeDownCast(&cells);
  assert(grid);
  types_.resize(cells_);
  for (std::size_t i = 0; i < types_.size(); ++i)
    types_[i] = std::uint8_t(grid->GetCellType(vtkIdType(i)));
  grid->GetCells()->ConvertTo64BitStorage();
  ends_ = numbers_of(grid->GetCells()->GetOffsetsArray(), own_ends_);
  points_ = numbers_of(grid->GetCells()->GetConnectivityArray(), own_points_);
}

void CellCorners::compute(std::size_t cell, std::array<vtkTypeInt64, 8>& numbers) const {
  // In 32 bits, whose division is the faster one: there are no more cells.
  const auto nx = std::uint32_t(dimensions_[0]), ny = std::uint32_t(dimensions_[1]),
             at = std::uint32_t(cell), row = at / (nx - 1), layer = row / (ny - 1);
  const vtkTypeInt64 up = vtkTypeInt64(nx) * ny;
  const vtkTypeInt64 first =
      at - row * (nx - 1) + vtkTypeInt64(nx) * (row - layer * (ny - 1)) + up * layer;
  numbers = {first,      first + 1,      first + nx + 1,      first + nx,
             first + up, first + up + 1, first + up + nx + 1, first + up + nx};
}

Box3 CellCorners::box(std::size_t cell) const {
  std::array<vtkTypeInt64, 8> eight;
  Box3 box;
  for (const vtkTypeInt64 point : points(cell, eight)) box.extend(place(point));
  return box;
}

}  // namespace pellucid::fields
