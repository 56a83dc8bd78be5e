// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/sampled/cell_checks.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <span>

#include "core/error.h"
#include "readers/vtk/shown_cells.h"

namespace pellucid::fields {
namespace {

using Path = std::filesystem::path;

[[noreturn]] void fail(const Path& path, std::string_view why) {
  throw InputError(fmt::format("{}: {}", path.string(), why));
}

constexpr int volume_cells[] = {VTK_TETRA,
                                VTK_VOXEL,
                                VTK_HEXAHEDRON,
                                VTK_WEDGE,
                                VTK_PYRAMID,
                                VTK_PENTAGONAL_PRISM,
                                VTK_HEXAGONAL_PRISM,
                                VTK_QUADRATIC_TETRA,
                                VTK_QUADRATIC_HEXAHEDRON,
                                VTK_QUADRATIC_WEDGE,
                                VTK_QUADRATIC_PYRAMID,
                                VTK_TRIQUADRATIC_HEXAHEDRON,
                                VTK_QUADRATIC_LINEAR_WEDGE,
                                VTK_BIQUADRATIC_QUADRATIC_WEDGE,
                                VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON};
constexpr int lower_dimensional[] = {
    VTK_EMPTY_CELL,     VTK_VERTEX,          VTK_POLY_VERTEX,
    VTK_LINE,           VTK_POLY_LINE,       VTK_TRIANGLE,
    VTK_TRIANGLE_STRIP, VTK_POLYGON,         VTK_PIXEL,
    VTK_QUAD,           VTK_QUADRATIC_EDGE,  VTK_QUADRATIC_TRIANGLE,
    VTK_QUADRATIC_QUAD, VTK_BIQUADRATIC_QUAD};

bool is_among(std::span<const int> types, int type) {
  return std::ranges::find(types, type) != types.end();
}

void check_type(vtkIdType number, int type, const Path& path) {
  if (!is_among(volume_cells, type))
    fail(path, fmt::format("cell {} is of VTK type {}; accepted: tetrahedra, hexahedra, voxels, "
                           "wedges, pyramids, prisms and their quadratic forms",
                           number, type));
}

/// The grid's volume cells alone, without those that it hides. Their indices and numbers of points
/// have been checked where the file was parsed (readers/vtk/cell_rules.h).
vtkSmartPointer<vtkDataSet> volume_of(vtkUnstructuredGrid* grid, const Path& path) {
  const auto volume = vtkSmartPointer<vtkUnstructuredGrid>::New();
  volume->SetPoints(grid->GetPoints());
  volume->Allocate(grid->GetNumberOfCells());
  vtkNew<vtkIdList> points;
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i) {
    const int type = grid->GetCellType(i);
    if (is_among(lower_dimensional, type)) continue;
    check_type(i, type, path);
    if (readers::hides_cell(grid, i)) continue;
    grid->GetCells()->GetCellAtId(i, points);
    volume->InsertNextCell(type, points);
  }
  return volume;
}

}  // namespace

vtkSmartPointer<vtkDataSet> checked_volume(vtkDataSet* data, const Path& path) {
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data)) return volume_of(grid, path);
  if (vtkImageData::SafeDownCast(data) || vtkRectilinearGrid::SafeDownCast(data))
    return readers::shown_cells(data);
  auto* structured = vtkStructuredGrid::SafeDownCast(data);
  if (!structured)
    fail(path, fmt::format("it holds a {}; accepted: image, rectilinear, structured and "
                           "unstructured data",
                           data->GetClassName()));
  int size[3];
  structured->GetDimensions(size);
  if (size[0] < 2 || size[1] < 2 || size[2] < 2)
    fail(path, fmt::format("{} × {} × {} samples; a field needs two or more along each axis",
                           size[0], size[1], size[2]));
  if (readers::hides_cells(data)) return readers::shown_cells(data);
  return data;
}

}  // namespace pellucid::fields
