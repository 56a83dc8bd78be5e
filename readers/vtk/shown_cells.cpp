// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vtk/shown_cells.h"

#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataSet.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

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

vtkSmartPointer<vtkDataSet> shown_cells(vtkDataSet* data, std::vector<vtkIdType>* numbers) {
  const auto shown = vtkSmartPointer<vtkUnstructuredGrid>::New();
  shown->SetPoints(points_of(data));
  shown->GetPointData()->ShallowCopy(data->GetPointData());
  shown->GetPointData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  shown->GetCellData()->CopyAllocate(data->GetCellData());
  shown->Allocate(data->GetNumberOfCells());
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i) {
    data->GetCellPoints(i, corners);
    if (hides_cell(data, i) || corners->GetNumberOfIds() == 0) continue;
    insert(data, i, corners, shown);
    if (numbers) numbers->push_back(i);
    shown->GetCellData()->CopyData(data->GetCellData(), i, shown->GetNumberOfCells() - 1);
  }
  shown->GetCellData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  return shown;
}

}  // namespace pellucid::readers
