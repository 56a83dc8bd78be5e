// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vtk/shown_cells.h"

#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataSet.h>
#include <vtkGenericCell.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include "readers/vtk/duplicate_solids.h"

namespace pellucid::readers {
namespace {

constexpr int hidden_cell = vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::DUPLICATECELL;
constexpr int hidden_point = vtkDataSetAttributes::HIDDENPOINT;

/// Of an array that is missing or too short nothing is marked.
bool is_marked(vtkUnsignedCharArray* marks, vtkIdType i, int flags) {
  return marks && i < marks->GetNumberOfTuples() && (marks->GetValue(i) & flags) != 0;
}

bool any_marked(vtkUnsignedCharArray* marks, int flags) {
  for (vtkIdType i = 0; marks && i < marks->GetNumberOfTuples(); ++i)
    if (is_marked(marks, i, flags)) return true;
  return false;
}

vtkSmartPointer<vtkPoints> points_of(vtkDataSet* data) {
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(data->GetNumberOfPoints());
  double x[3];
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) {
    data->GetPoint(i, x);
    points->SetPoint(i, x);
  }
  return points;
}

/// A polyhedron is known by its faces, not by its corners alone.
void insert(vtkDataSet* data, vtkIdType cell, vtkIdList* corners, vtkUnstructuredGrid* shown) {
  const int type = data->GetCellType(cell);
  auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
  if (type == VTK_POLYHEDRON && grid) grid->GetFaceStream(cell, corners);
  shown->InsertNextCell(type, corners);
}

bool is_solid(vtkDataSet* data, vtkIdType cell) {
  vtkNew<vtkGenericCell> kind;
  kind->SetCellType(data->GetCellType(cell));
  return kind->GetCellDimension() == 3;
}

/// Whether a duplicate is nothing else: not hidden as well.
bool is_duplicate_alone(vtkDataSet* data, vtkIdType cell) {
  vtkUnsignedCharArray* marks = data->GetCellGhostArray();
  return is_marked(marks, cell, vtkDataSetAttributes::DUPLICATECELL) &&
         !is_marked(marks, cell, vtkDataSetAttributes::HIDDENCELL);
}

}  // namespace

bool hides_cells(vtkDataSet* data) {
  return any_marked(data->GetCellGhostArray(), hidden_cell) ||
         any_marked(data->GetPointGhostArray(), hidden_point);
}

bool hides_point(vtkDataSet* data, vtkIdType point) {
  return is_marked(data->GetPointGhostArray(), point, hidden_point);
}

bool hides_cell(vtkDataSet* data, vtkIdType cell) {
  if (is_marked(data->GetCellGhostArray(), cell, hidden_cell)) return true;
  if (!data->GetPointGhostArray()) return false;
  vtkNew<vtkIdList> corners;
  data->GetCellPoints(cell, corners);
  for (vtkIdType k = 0; k < corners->GetNumberOfIds(); ++k)
    if (hides_point(data, corners->GetId(k))) return true;
  return false;
}

namespace {

/// The cells that `keep(cell)` holds for, as an unstructured grid with all points and arrays;
/// `numbers`, where given, gets the number in `data` of each.
template <class Keep>
vtkSmartPointer<vtkUnstructuredGrid> cells_with(vtkDataSet* data, const Keep& keep,
                                                std::vector<vtkIdType>* numbers) {
  auto kept = vtkSmartPointer<vtkUnstructuredGrid>::New();
  kept->SetPoints(points_of(data));
  kept->GetPointData()->ShallowCopy(data->GetPointData());
  kept->GetPointData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  kept->GetCellData()->CopyAllocate(data->GetCellData());
  kept->Allocate(data->GetNumberOfCells());
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i) {
    data->GetCellPoints(i, corners);
    if (!keep(i) || corners->GetNumberOfIds() == 0) continue;
    insert(data, i, corners, kept);
    if (numbers) numbers->push_back(i);
    kept->GetCellData()->CopyData(data->GetCellData(), i, kept->GetNumberOfCells() - 1);
  }
  return kept;
}

}  // namespace

vtkSmartPointer<vtkDataSet> shown_cells(vtkDataSet* data, std::vector<vtkIdType>* numbers) {
  const auto shown = cells_with(
      data, [&](vtkIdType i) { return !hides_cell(data, i); }, numbers);
  shown->GetCellData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  return shown;
}

vtkSmartPointer<vtkDataSet> cells_and_duplicate_solids(vtkDataSet* data) {
  return cells_with(
      data,
      [&](vtkIdType i) {
        return !hides_cell(data, i) || (is_duplicate_alone(data, i) && is_solid(data, i));
      },
      nullptr);
}

}  // namespace pellucid::readers
