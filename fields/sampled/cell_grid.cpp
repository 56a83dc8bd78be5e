// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/sampled/cell_grid.h"

#include <fmt/format.h>
#include <vtkDataArray.h>
#include <vtkGenericCell.h>
#include <vtkIdList.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>

#include "fields/sampled/cell_checks.h"

namespace pellucid::fields {
namespace {

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

double error_of_constant_cells(const CellGrid& grid) {
  std::vector<Vec3> sums(std::size_t(grid.cells->GetNumberOfPoints()), Vec3(0));
  std::vector<int> counts(sums.size(), 0);
  const auto for_each_corner_of = [&](const auto& visit) {
    vtkNew<vtkIdList> corners;
    for (vtkIdType i = 0; i < grid.cells->GetNumberOfCells(); ++i) {
      grid.cells->GetCellPoints(i, corners);
      for (vtkIdType k = 0; k < corners->GetNumberOfIds(); ++k)
        visit(grid.velocity(i), std::size_t(corners->GetId(k)));
    }
  };
  for_each_corner_of([&](const Vec3& v, std::size_t point) { sums[point] += v, ++counts[point]; });
  double largest = 0;
  for_each_corner_of([&](const Vec3& v, std::size_t point) {
    const double error = glm::length(v - sums[point] / double(counts[point]));
    if (std::isfinite(error)) largest = std::max(largest, error);
  });
  return largest;
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
  if (constant) return error_of_constant_cells(*this);
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

namespace {

Box3 box_of(vtkDataSet* cells) {
  double bounds[6];
  cells->GetBounds(bounds);
  return {{bounds[0], bounds[2], bounds[4]}, {bounds[1], bounds[3], bounds[5]}};
}

/// Of each point or cell of the checked ones. Points on a plane are there twice.
std::vector<Vec3> velocities_of(const CheckedCells& checked, const Vectors& vectors) {
  const vtkIdType given = vectors.values->GetNumberOfTuples();
  const vtkIdType count =
      vectors.of_cells ? checked.cells->GetNumberOfCells() : checked.cells->GetNumberOfPoints();
  std::vector<Vec3> velocities;
  velocities.reserve(std::size_t(count));
  for (vtkIdType i = 0; i < count; ++i) {
    const bool is_renumbered = vectors.of_cells && !checked.numbers.empty();
    const vtkIdType number = is_renumbered ? checked.numbers[std::size_t(i)] : i % given;
    velocities.push_back(tuple_at(vectors.values, number));
  }
  return velocities;
}

}  // namespace

CellGrid make_cell_grid(vtkDataSet* data, const Vectors& vectors,
                        const std::filesystem::path& path) {
  const CheckedCells checked = checked_cells(data, path);
  return {checked.cells,    velocities_of(checked, vectors),
          vectors.of_cells, checked.plane,
          checked.bounds,   box_of(checked.cells)};
}

}  // namespace pellucid::fields
