// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/simulations/permuted_axes.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkRectilinearGrid.h>
#include <vtkSmartPointer.h>

namespace pellucid::readers {
namespace {

/// Values along each axis, and how far apart in the new order those next to each other are.
struct Layout {
  int size[3];
  vtkIdType stride[3];
};

vtkSmartPointer<vtkDataArray> permuted(vtkDataArray& array, const Layout& layout) {
  const auto result = vtk::TakeSmartPointer(array.NewInstance());
  result->SetName(array.GetName());
  result->SetNumberOfComponents(array.GetNumberOfComponents());
  result->SetNumberOfTuples(array.GetNumberOfTuples());
  const auto& [size, stride] = layout;
  vtkIdType from = 0;
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i)
        result->SetTuple(i * stride[0] + j * stride[1] + k * stride[2], from++, &array);
  return result;
}

}  // namespace

void permute_axes(vtkRectilinearGrid& grid, const std::array<int, 3>& order) {
  if (order == std::array{0, 1, 2}) return;
  Layout layout;
  grid.GetDimensions(layout.size);
  vtkDataArray* const axes[3] = {grid.GetXCoordinates(), grid.GetYCoordinates(),
                                 grid.GetZCoordinates()};
  int size[3];
  vtkSmartPointer<vtkDataArray> coordinates[3];
  for (int a = 0; a < 3; ++a) {
    size[order[std::size_t(a)]] = layout.size[a];
    coordinates[order[std::size_t(a)]] = axes[a];
  }
  const vtkIdType strides[3] = {1, size[0], vtkIdType(size[0]) * size[1]};
  for (int a = 0; a < 3; ++a) layout.stride[a] = strides[order[std::size_t(a)]];
  for (int n = 0; n < grid.GetPointData()->GetNumberOfArrays(); ++n)
    if (vtkDataArray* array = grid.GetPointData()->GetArray(n))
      grid.GetPointData()->AddArray(
          permuted(*array, layout));  // in the place of the one of its name
  grid.SetDimensions(size);
  grid.SetXCoordinates(coordinates[0]);
  grid.SetYCoordinates(coordinates[1]);
  grid.SetZCoordinates(coordinates[2]);
}

}  // namespace pellucid::readers
