// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/sampled/cell_checks.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <iterator>

#include "core/error.h"
#include "readers/vtk/shown_cells.h"

namespace pellucid::fields {
namespace {

using Path = std::filesystem::path;

[[noreturn]] void fail(const Path& path, std::string_view why) {
  throw InputError(fmt::format("{}: {}", path.string(), why));
}

struct VolumeCell {
  int type;
  vtkIdType points;
};
constexpr VolumeCell volume_cells[] = {
    {VTK_TETRA, 4},
    {VTK_VOXEL, 8},
    {VTK_HEXAHEDRON, 8},
    {VTK_WEDGE, 6},
    {VTK_PYRAMID, 5},
    {VTK_PENTAGONAL_PRISM, 10},
    {VTK_HEXAGONAL_PRISM, 12},
    {VTK_QUADRATIC_TETRA, 10},
    {VTK_QUADRATIC_HEXAHEDRON, 20},
    {VTK_QUADRATIC_WEDGE, 15},
    {VTK_QUADRATIC_PYRAMID, 13},
    {VTK_TRIQUADRATIC_HEXAHEDRON, 27},
    {VTK_QUADRATIC_LINEAR_WEDGE, 12},
    {VTK_BIQUADRATIC_QUADRATIC_WEDGE, 18},
    {VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON, 24},
};
constexpr int lower_dimensional[] = {
    VTK_EMPTY_CELL,     VTK_VERTEX,          VTK_POLY_VERTEX,
    VTK_LINE,           VTK_POLY_LINE,       VTK_TRIANGLE,
    VTK_TRIANGLE_STRIP, VTK_POLYGON,         VTK_PIXEL,
    VTK_QUAD,           VTK_QUADRATIC_EDGE,  VTK_QUADRATIC_TRIANGLE,
    VTK_QUADRATIC_QUAD, VTK_BIQUADRATIC_QUAD};

const VolumeCell* find_volume_cell(int type) {
  const auto found = std::find_if(std::begin(volume_cells), std::end(volume_cells),
                                  [&](const VolumeCell& cell) { return cell.type == type; });
  return found == std::end(volume_cells) ? nullptr : found;
}

bool is_lower_dimensional(int type) {
  return std::find(std::begin(lower_dimensional), std::end(lower_dimensional), type) !=
         std::end(lower_dimensional);
}

/// Offsets have to ascend from 0 to the connectivity's length, or reading a cell reads elsewhere.
void check_offsets(vtkUnstructuredGrid* grid, const Path& path) {
  vtkCellArray* cells = grid->GetCells();
  vtkUnsignedCharArray* types = grid->GetCellTypesArray();
  if (!cells || !types || types->GetNumberOfTuples() != cells->GetNumberOfCells())
    fail(path, "it does not have one type per cell");
  vtkDataArray* offsets = cells->GetOffsetsArray();
  for (vtkIdType i = 0; i < offsets->GetNumberOfTuples(); ++i)
    if (i == 0 ? offsets->GetTuple1(0) != 0 : offsets->GetTuple1(i) < offsets->GetTuple1(i - 1))
      fail(path, fmt::format("offset of cell {} is {}; offsets have to ascend from 0", i,
                             offsets->GetTuple1(i)));
  const vtkIdType length = cells->GetConnectivityArray()->GetNumberOfTuples();
  if (offsets->GetTuple1(offsets->GetNumberOfTuples() - 1) != double(length))
    fail(path, "the last cell's offset is not the length of the connectivity");
}

void check_cell(vtkIdType number, int type, vtkIdList* points, vtkIdType point_count,
                const Path& path) {
  const VolumeCell* known = find_volume_cell(type);
  if (!known)
    fail(path, fmt::format("cell {} is of VTK type {}; accepted: tetrahedra, hexahedra, voxels, "
                           "wedges, pyramids, prisms and their quadratic forms",
                           number, type));
  if (points->GetNumberOfIds() != known->points)
    fail(path, fmt::format("cell {} of VTK type {} has {} points; expected {}", number, type,
                           points->GetNumberOfIds(), known->points));
  for (vtkIdType i = 0; i < known->points; ++i)
    if (points->GetId(i) < 0 || points->GetId(i) >= point_count)
      fail(path, fmt::format("cell {}: point index {}, but the file has {} points", number,
                             points->GetId(i), point_count));
}

/// The grid's checked volume cells alone, without those that it hides.
vtkSmartPointer<vtkDataSet> volume_of(vtkUnstructuredGrid* grid, const Path& path) {
  check_offsets(grid, path);
  const auto volume = vtkSmartPointer<vtkUnstructuredGrid>::New();
  volume->SetPoints(grid->GetPoints());
  volume->Allocate(grid->GetNumberOfCells());
  vtkNew<vtkIdList> points;
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i) {
    const int type = grid->GetCellType(i);
    if (is_lower_dimensional(type)) continue;
    grid->GetCells()->GetCellAtId(i, points);
    check_cell(i, type, points, grid->GetNumberOfPoints(), path);
    if (readers::hides_cell(grid, i)) continue;
    volume->InsertNextCell(type, points);
  }
  return volume;
}

}  // namespace

vtkSmartPointer<vtkDataSet> checked_volume(vtkDataSet* data, const Path& path) {
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data)) return volume_of(grid, path);
  if (vtkImageData::SafeDownCast(data) || vtkRectilinearGrid::SafeDownCast(data))
    return readers::shown_cells(data, path);
  auto* structured = vtkStructuredGrid::SafeDownCast(data);
  if (!structured)
    fail(path, fmt::format("it holds a {}; accepted: image, rectilinear, structured and "
                           "unstructured data",
                           data->GetClassName()));
  int size[3];
  structured->GetDimensions(size);
  if (vtkIdType(size[0]) * size[1] * size[2] != structured->GetNumberOfPoints())
    fail(path, "its extent is not the number of its points");
  if (size[0] < 2 || size[1] < 2 || size[2] < 2)
    fail(path, fmt::format("{} × {} × {} samples; a field needs two or more along each axis",
                           size[0], size[1], size[2]));
  if (readers::hides_cells(data)) return readers::shown_cells(data, path);
  return data;
}

}  // namespace pellucid::fields
