// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/sampled/cell_grid.h"

#include <fmt/format.h>
#include <vtkDataArray.h>
#include <vtkGenericCell.h>

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
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
  Vec3 middle;
  cell.GetParametricCenter(&middle.x);
  return jacobian([&](const Vec3& at) { return slopes(cell, &at.x); },
                  Vec3(parametric[0], parametric[1], parametric[2]), middle);
}

double CellGrid::smallest_width() const {
  const auto narrower = [](double a, double b) { return std::min(a, b); };
  const double smallest = parallel_sum(
      tbb::blocked_range<vtkIdType>(0, cells->GetNumberOfCells(), 4096), bounds.diagonal(),
      [&](const tbb::blocked_range<vtkIdType>& part, double least) {
        for (vtkIdType i = part.begin(); i < part.end(); ++i) {
          double box[6];
          cells->GetCellBounds(i, box);
          const double diagonal =
              Box3{{box[0], box[2], box[4]}, {box[1], box[3], box[5]}}.diagonal();
          if (diagonal > 0) least = std::min(least, diagonal);
        }
        return least;
      },
      narrower);
  return smallest / std::sqrt(3.0);
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
