// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/sampled/cell_grid.h"

#include <fmt/format.h>
#include <vtkDataArray.h>
#include <vtkGenericCell.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "fields/finite.h"
#include "fields/sampled/cell_checks.h"

namespace pellucid::fields {
namespace {

using Path = std::filesystem::path;

[[noreturn]] void fail(const Path& path, std::string_view why) {
  throw InputError(fmt::format("{}: {}", path.string(), why));
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

Vec3 CellGrid::point(vtkIdType number) const { return point_at(cells, number); }

CellGrid::Slopes CellGrid::slopes(vtkGenericCell& cell, const double parametric[3]) const {
  double derivatives[3 * largest_cell];
  cell.InterpolateDerivs(parametric, derivatives);
  const int count = cell.GetNumberOfPoints();
  Slopes result{Mat3(0), Mat3(0)};
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < count; ++i) {
      const double weight = derivatives[axis * count + i];
      result.position[axis] += weight * point(cell.GetPointId(i));
      result.velocity[axis] += weight * velocity(cell.GetPointId(i));
    }
  return result;
}

// VTK's own Derivatives() does the same, but prints where a cell is flat; here that gives
// infinities.
Mat3 CellGrid::jacobian(vtkGenericCell& cell, const double parametric[3]) const {
  const Slopes at = slopes(cell, parametric);
  return at.velocity * glm::inverse(at.position);
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
  grid.cells = checked_volume(data, path);
  if (grid.cells->GetNumberOfCells() == 0) fail(path, "it has no volume cells");
  grid.bounds = checked_bounds(grid.cells, path);
  grid.velocities.reserve(std::size_t(vectors->GetNumberOfTuples()));
  for (vtkIdType i = 0; i < vectors->GetNumberOfTuples(); ++i)
    grid.velocities.push_back(tuple_at(vectors, i));
  return grid;
}

}  // namespace pellucid::fields
