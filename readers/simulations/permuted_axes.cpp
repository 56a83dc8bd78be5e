// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/simulations/permuted_axes.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
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

/// Puts the values of all points in their new order, and returns how many there are along each
/// axis.
std::array<int, 3> permute_values(vtkDataSet& grid, const int* old_size,
                                  const std::array<int, 3>& order) {
  std::array<int, 3> size{};
  Layout layout;
  for (std::size_t a = 0; a < 3; ++a) {
    layout.size[a] = old_size[a];
    size[std::size_t(order[a])] = old_size[a];
  }
  const vtkIdType strides[3] = {1, size[0], vtkIdType(size[0]) * size[1]};
  for (std::size_t a = 0; a < 3; ++a) layout.stride[a] = strides[order[a]];
  vtkPointData& arrays = *grid.GetPointData();
  for (int n = 0; n < arrays.GetNumberOfArrays(); ++n)
    if (vtkDataArray* array = arrays.GetArray(n))
      arrays.AddArray(permuted(*array, layout));  // in the place of the one of its name
  return size;
}

constexpr std::array same{0, 1, 2};

}  // namespace

void permute_axes(vtkRectilinearGrid& grid, const std::array<int, 3>& order) {
  if (order == same) return;
  const vtkSmartPointer<vtkDataArray> axes[3] = {grid.GetXCoordinates(), grid.GetYCoordinates(),
                                                 grid.GetZCoordinates()};
  vtkDataArray* coordinates[3];
  for (std::size_t a = 0; a < 3; ++a) coordinates[order[a]] = axes[a];
  grid.SetDimensions(permute_values(grid, grid.GetDimensions(), order).data());
  grid.SetXCoordinates(coordinates[0]);
  grid.SetYCoordinates(coordinates[1]);
  grid.SetZCoordinates(coordinates[2]);
}

void permute_axes(vtkImageData& image, const std::array<int, 3>& order) {
  if (order == same) return;
  double spacing[3];
  for (std::size_t a = 0; a < 3; ++a) spacing[order[a]] = image.GetSpacing()[a];
  image.SetDimensions(permute_values(image, image.GetDimensions(), order).data());
  image.SetSpacing(spacing);
}

}  // namespace pellucid::readers
