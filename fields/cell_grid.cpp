#include "fields/cell_grid.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellTypes.h>
#include <vtkDataArray.h>
#include <vtkGenericCell.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkStructuredGrid.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "fields/finite.h"

namespace pellucid {
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

/// The grid's checked volume cells alone.
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
    volume->InsertNextCell(type, points);
  }
  return volume;
}

vtkSmartPointer<vtkDataSet> volume_of(vtkDataSet* data, const Path& path) {
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data)) return volume_of(grid, path);
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
  return data;
}

Vec3 tuple_at(vtkDataArray* array, vtkIdType i) {
  double v[3];
  array->GetTuple(i, v);
  return {v[0], v[1], v[2]};
}

Vec3 point_at(vtkDataSet* data, vtkIdType i) {
  double x[3];
  data->GetPoint(i, x);
  return {x[0], x[1], x[2]};
}

Box3 checked_bounds(vtkDataSet* data, const Path& path) {
  Box3 bounds;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) {
    const Vec3 x = point_at(data, i);
    if (!is_finite(x)) fail(path, fmt::format("point {} is not finite", i));
    bounds.extend(x);
  }
  return bounds;
}

template <class Visit>
void for_each_cell(vtkDataSet* data, const Visit& visit) {
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i) {
    data->GetCell(i, cell);
    if (cell->GetNumberOfPoints() > 0) visit(*cell);  // a hidden cell is empty
  }
}

template <class Visit>
void for_each_corner(const CellGrid& grid, vtkGenericCell& cell, const Visit& visit) {
  const double* corners = cell.GetParametricCoords();
  for (int i = 0; i < cell.GetNumberOfPoints(); ++i)
    visit(cell.GetPointId(i), grid.jacobian(cell, corners + 3 * i));
}

Vec3 center_of(const CellGrid& grid, vtkGenericCell& cell) {
  Vec3 sum(0);
  for (int i = 0; i < cell.GetNumberOfPoints(); ++i)
    sum += point_at(grid.cells, cell.GetPointId(i));
  return sum / double(cell.GetNumberOfPoints());
}

/// By point, over the cells around it.
std::vector<Mat3> mean_jacobians(const CellGrid& grid) {
  std::vector<Mat3> sums(grid.velocities.size(), Mat3(0));
  std::vector<int> counts(grid.velocities.size(), 0);
  for_each_cell(grid.cells, [&](vtkGenericCell& cell) {
    for_each_corner(grid, cell, [&](vtkIdType point, const Mat3& jacobian) {
      sums[std::size_t(point)] += jacobian;
      ++counts[std::size_t(point)];
    });
  });
  for (std::size_t i = 0; i < sums.size(); ++i) sums[i] /= double(std::max(counts[i], 1));
  return sums;
}

}  // namespace

// Through the derivatives of position and velocity by the parametric coordinates. VTK's own
// Derivatives() does the same, but prints where a cell is flat; here that gives infinities.
Mat3 CellGrid::jacobian(vtkGenericCell& cell, const double parametric[3]) const {
  double derivatives[3 * largest_cell];
  cell.InterpolateDerivs(parametric, derivatives);
  const int count = cell.GetNumberOfPoints();
  Mat3 position(0), value(0);
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < count; ++i) {
      const double weight = derivatives[axis * count + i];
      position[axis] += weight * point_at(cells, cell.GetPointId(i));
      value[axis] += weight * velocity(cell.GetPointId(i));
    }
  return value * glm::inverse(position);
}

double CellGrid::smallest_width() const {
  double smallest = bounds.diagonal();
  for_each_cell(cells, [&](vtkGenericCell& cell) {
    Box3 box;
    for (int i = 0; i < cell.GetNumberOfPoints(); ++i)
      box.extend(point_at(cells, cell.GetPointId(i)));
    if (box.diagonal() > 0) smallest = std::min(smallest, box.diagonal());
  });
  return smallest / std::sqrt(3.0);
}

double CellGrid::sampling_error() const {
  const std::vector<Mat3> mean = mean_jacobians(*this);
  double largest = 0;
  for_each_cell(cells, [&](vtkGenericCell& cell) {
    const Vec3 center = center_of(*this, cell);
    for_each_corner(*this, cell, [&](vtkIdType point, const Mat3& jacobian) {
      const Vec3 arm = point_at(cells, point) - center;
      const double error = 0.5 * glm::length((mean[std::size_t(point)] - jacobian) * arm);
      if (std::isfinite(error)) largest = std::max(largest, error);
    });
  });
  return largest;
}

CellGrid make_cell_grid(vtkDataSet* data, vtkDataArray* vectors, const Path& path) {
  CellGrid grid;
  grid.cells = volume_of(data, path);
  if (grid.cells->GetNumberOfCells() == 0) fail(path, "it has no volume cells");
  grid.bounds = checked_bounds(grid.cells, path);
  grid.velocities.reserve(std::size_t(vectors->GetNumberOfTuples()));
  for (vtkIdType i = 0; i < vectors->GetNumberOfTuples(); ++i)
    grid.velocities.push_back(tuple_at(vectors, i));
  return grid;
}

}  // namespace pellucid
