// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/files/cell_average.h"

#include <vtkCellType.h>
#include <vtkCellTypes.h>
#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkGenericCell.h>
#include <vtkIdList.h>
#include <vtkNew.h>

#include <array>
#include <limits>
#include <vector>

#include "readers/vtk/shown_cells.h"

namespace pellucid::fields {
namespace {

/// By VTK's number of a cell's type; -1 where there is no such type.
int dimension_of(int type) {
  static const std::array<int, 256> dimensions = [] {
    std::array<int, 256> all;
    all.fill(-1);
    for (int known = 0; known < VTK_NUMBER_OF_CELL_TYPES; ++known)
      if (const auto cell = vtk::TakeSmartPointer(vtkGenericCell::InstantiateCell(known)))
        all[std::size_t(known)] = cell->GetCellDimension();
    return all;
  }();
  return type >= 0 && type < 256 ? dimensions[std::size_t(type)] : -1;
}

int highest_dimension(vtkDataSet& data) {
  int highest = -1;
  for (vtkIdType i = 0; i < data.GetNumberOfCells() && highest < 3; ++i)
    highest = std::max(highest, dimension_of(data.GetCellType(i)));
  return highest;
}

/// Sums over the cells around each point.
class Sums {
 public:
  Sums(vtkIdType points, int components)
      : components_(std::size_t(components)),
        sums_(std::size_t(points) * components_),
        counts_(std::size_t(points)) {}

  void add(vtkIdList& corners, const std::vector<double>& value) {
    for (vtkIdType k = 0; k < corners.GetNumberOfIds(); ++k) {
      const auto point = std::size_t(corners.GetId(k));
      for (std::size_t c = 0; c < components_; ++c) sums_[point * components_ + c] += value[c];
      ++counts_[point];
    }
  }

  void write_means(vtkDataArray& array) const {
    for (std::size_t i = 0; i < counts_.size(); ++i)
      for (std::size_t c = 0; c < components_; ++c)
        array.SetComponent(vtkIdType(i), int(c),
                           counts_[i] > 0 ? sums_[i * components_ + c] / counts_[i]
                                          : std::numeric_limits<double>::quiet_NaN());
  }

 private:
  std::size_t components_;
  std::vector<double> sums_;
  std::vector<int> counts_;
};

vtkSmartPointer<vtkDataArray> array_like(vtkDataArray& of_cells, vtkIdType points) {
  vtkSmartPointer<vtkDataArray> array;
  if (of_cells.GetDataType() == VTK_FLOAT)
    array = vtkSmartPointer<vtkFloatArray>::New();
  else
    array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetNumberOfComponents(of_cells.GetNumberOfComponents());
  array->SetNumberOfTuples(points);
  array->SetName(of_cells.GetName());
  return array;
}

}  // namespace

vtkSmartPointer<vtkDataArray> averaged_to_points(vtkDataSet& data, vtkDataArray& of_cells) {
  Sums sums(data.GetNumberOfPoints(), of_cells.GetNumberOfComponents());
  const int highest = highest_dimension(data);
  const bool hides = readers::hides_cells(&data);
  std::vector<double> value(std::size_t(of_cells.GetNumberOfComponents()));
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < data.GetNumberOfCells(); ++i) {
    if (dimension_of(data.GetCellType(i)) != highest) continue;
    if (hides && readers::hides_cell(&data, i)) continue;
    data.GetCellPoints(i, corners);
    of_cells.GetTuple(i, value.data());
    sums.add(*corners, value);
  }
  auto means = array_like(of_cells, data.GetNumberOfPoints());
  sums.write_means(*means);
  return means;
}

}  // namespace pellucid::fields
