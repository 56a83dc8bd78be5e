// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vtk/ascending_axes.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkPointData.h>
#include <vtkRectilinearGrid.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pellucid::readers {
namespace {

/// Values along each axis, the first one's next to each other.
using Size = std::array<vtkIdType, 3>;

/// Exchanges layers across an axis: the first with the last, and so on.
void reverse(vtkDataArray& array, const Size& size, int axis) {
  const vtkIdType tuple = vtkIdType(array.GetNumberOfComponents()) * array.GetDataTypeSize();
  vtkIdType run = tuple;  // bytes that stay together
  for (int a = 0; a < axis; ++a) run *= size[std::size_t(a)];
  const vtkIdType count = size[std::size_t(axis)];
  if (count < 2 || array.GetNumberOfTuples() * tuple % (run * count) != 0) return;
  auto* const first = static_cast<char*>(array.GetVoidPointer(0));
  char* const end = first + array.GetNumberOfTuples() * tuple;
  for (char* slab = first; slab < end; slab += run * count)
    for (vtkIdType i = 0; i < count / 2; ++i)
      std::swap_ranges(slab + i * run, slab + (i + 1) * run, slab + (count - 1 - i) * run);
}

void reverse(vtkFieldData& arrays, const Size& size, int axis) {
  for (int k = 0; k < arrays.GetNumberOfArrays(); ++k)
    if (vtkDataArray* array = arrays.GetArray(k);
        array && array->GetNumberOfTuples() == size[0] * size[1] * size[2])
      reverse(*array, size, axis);
}

void reverse_values(vtkDataSet& data, const int* dimensions, int axis) {
  Size points, cells;
  for (std::size_t a = 0; a < 3; ++a)
    points[a] = dimensions[a], cells[a] = std::max(dimensions[a] - 1, 1);
  reverse(*data.GetPointData(), points, axis);
  reverse(*data.GetCellData(), cells, axis);
}

/// Says by steps below 0 what the directions say of axes that run against the world's.
void flip_axes(vtkImageData& image) {
  double spacing[3];
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column)
      if (std::abs(image.GetDirectionMatrix()->GetElement(row, column)) != (row == column ? 1 : 0))
        return;
    spacing[row] = image.GetSpacing()[row] * image.GetDirectionMatrix()->GetElement(row, row);
  }
  image.SetDirectionMatrix(1, 0, 0, 0, 1, 0, 0, 0, 1);
  image.SetSpacing(spacing);
}

void make_axes_ascend(vtkImageData& image) {
  flip_axes(image);
  if (!image.GetDirectionMatrix()->IsIdentity()) return;
  double origin[3], spacing[3];
  image.GetOrigin(origin), image.GetSpacing(spacing);
  const int* extent = image.GetExtent();
  for (int a = 0; a < 3; ++a) {
    if (!(spacing[a] < 0)) continue;
    reverse_values(image, image.GetDimensions(), a);
    origin[a] += (double(extent[2 * a]) + double(extent[2 * a + 1])) * spacing[a];
    spacing[a] = -spacing[a];
  }
  image.SetOrigin(origin), image.SetSpacing(spacing);
}

void make_axes_ascend(vtkRectilinearGrid& grid) {
  vtkDataArray* const axes[3] = {grid.GetXCoordinates(), grid.GetYCoordinates(),
                                 grid.GetZCoordinates()};
  for (int a = 0; a < 3; ++a) {
    if (!axes[a] || axes[a]->GetNumberOfTuples() != grid.GetDimensions()[a]) continue;
    const vtkIdType count = axes[a]->GetNumberOfTuples();
    if (count < 2 || !(axes[a]->GetComponent(count - 1, 0) < axes[a]->GetComponent(0, 0))) continue;
    reverse_values(grid, grid.GetDimensions(), a);
    reverse(*axes[a], {count, 1, 1}, 0);
  }
}

}  // namespace

void make_axes_ascend(vtkDataSet& data) {
  if (auto* image = vtkImageData::SafeDownCast(&data)) make_axes_ascend(*image);
  if (auto* grid = vtkRectilinearGrid::SafeDownCast(&data)) make_axes_ascend(*grid);
}

}  // namespace pellucid::readers
