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
#include <array>
#include <optional>
#include <span>

#include "core/files/bad_file.h"
#include "fields/finite.h"
#include "fields/sampled/planar_cells.h"
#include "readers/vtk/shown_cells.h"

namespace pellucid::fields {
namespace {

using Path = std::filesystem::path;

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
    bad_file(path,
             fmt::format("cell {} is of VTK type {}; accepted: tetrahedra, hexahedra, voxels, "
                         "wedges, pyramids, prisms and their quadratic forms",
                         number, type));
}

/// Only where there are volume cells a surface cell is but their border.
bool has_volume(vtkUnstructuredGrid* grid) {
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
    if (!is_among(lower_dimensional, grid->GetCellType(i))) return true;
  return false;
}

/// The grid's volume cells alone, without those that it hides. Their indices and numbers of points
/// have been checked where the file was parsed (readers/vtk/cell_rules.h).
void take_volume(vtkUnstructuredGrid* grid, const Path& path, CheckedCells& checked) {
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
    checked.numbers.push_back(i);
  }
  checked.cells = volume;
}

Box3 checked_bounds(vtkDataSet* data, const Path& path) {
  Box3 bounds;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) {
    double x[3];
    data->GetPoint(i, x);
    if (!is_finite(Vec3(x[0], x[1], x[2])))
      bad_file(path, fmt::format("point {} is not finite", i));
    bounds.extend({x[0], x[1], x[2]});
  }
  return bounds;
}

/// How many samples a structured grid has along its three axes, if it is one.
std::optional<std::array<int, 3>> dimensions_of(vtkDataSet* data) {
  std::array<int, 3> size{};
  if (auto* image = vtkImageData::SafeDownCast(data))
    return image->GetDimensions(size.data()), size;
  if (auto* grid = vtkRectilinearGrid::SafeDownCast(data))
    return grid->GetDimensions(size.data()), size;
  if (auto* grid = vtkStructuredGrid::SafeDownCast(data))
    return grid->GetDimensions(size.data()), size;
  return std::nullopt;
}

/// Along how many axes there are two samples or more.
int dimension_of(const std::array<int, 3>& size, const Path& path) {
  const auto dimension = int(std::ranges::count_if(size, [](int n) { return n >= 2; }));
  if (dimension < 2)
    bad_file(path, fmt::format("{} × {} × {} samples; a field needs two or more along two axes at "
                               "least",
                               size[0], size[1], size[2]));
  return dimension;
}

}  // namespace

std::span<const int> volume_cell_types() { return volume_cells; }

CheckedCells checked_cells(vtkDataSet* data, const Path& path) {
  CheckedCells checked{data, {}, std::nullopt, checked_bounds(data, path)};
  auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
  const auto size = dimensions_of(data);
  const bool is_volume = grid ? has_volume(grid) : size && dimension_of(*size, path) == 3;
  if (!is_volume) return planar_cells(*data, checked.bounds, path);
  if (grid)
    take_volume(grid, path, checked);
  else if (readers::hides_cells(data) || !vtkStructuredGrid::SafeDownCast(data))
    checked.cells = readers::shown_cells(data, &checked.numbers);
  if (checked.cells->GetNumberOfCells() == 0)
    bad_file(path, "it has no volume cells that it shows");
  return checked;
}

}  // namespace pellucid::fields
