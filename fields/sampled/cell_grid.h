// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkDataSet.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <vector>

#include "core/vec.h"
#include "fields/files/vector_array.h"
#include "fields/sampled/planar_field.h"

class vtkGenericCell;

namespace pellucid::fields {

/// A CellGrid holds volume cells with a velocity at each point, or one in each cell: checked, so
/// that VTK can search them safely. Positions are in world coordinates.
struct CellGrid {
  static constexpr int largest_cell = 27;  // most points of a cell that is accepted

  vtkSmartPointer<vtkDataSet> cells;
  std::vector<Vec3> velocities;  // by point or by cell, world units per unit of time
  bool constant = false;         // by cell
  std::optional<Plane> plane;    // set: the cells are prisms around it (CheckedCells)
  Box3 bounds;                   // of what the file has: flat where it lies on a plane
  Box3 search_box;               // of the cells

  Vec3 point(vtkIdType number) const;
  /// Returns the velocity of a point, or of a cell where it is constant.
  const Vec3& velocity(vtkIdType number) const { return velocities[std::size_t(number)]; }

  /// Slopes say how positions and velocities change with a cell's parametric coordinates: column k
  /// by the k-th.
  struct Slopes {
    Mat3 position, velocity;
  };
  Slopes slopes(vtkGenericCell& cell, const double parametric[3]) const;

  /// Returns the Jacobian of the cell's interpolant, per unit of time; column j is the derivative
  /// along axis j. Where points of the cell coincide, as on the axis of a polar grid, it is that of
  /// a thousandth of the way to the cell's middle; of a cell that is flat it is infinite.
  Mat3 jacobian(vtkGenericCell& cell, const double parametric[3]) const;
  /// The same of a cell whose slopes at parametric coordinates `slopes_at` returns.
  template <class SlopesAt>
  static Mat3 jacobian(const SlopesAt& slopes_at, const Vec3& parametric, const Vec3& middle) {
    constexpr double flat = 1e-8, way_in = 1e-3;
    Slopes at = slopes_at(parametric);
    const auto [shortest, longest] = std::minmax(
        {glm::length(at.position[0]), glm::length(at.position[1]), glm::length(at.position[2])});
    if (shortest <= flat * longest) at = slopes_at(parametric + way_in * (middle - parametric));
    return at.velocity * glm::inverse(at.position);
  }

  /// Returns the smallest width of all cells, in world units: a cell's width is the diagonal of its
  /// box over √3, a cube's edge. Slivers do not count as thin, since they say little about how
  /// finely a flow was sampled.
  double smallest_width() const;
};

/// Checks the cells of `data` and copies the velocities of its points or cells. Throws InputError,
/// naming `path`, as checked_cells() does.
CellGrid make_cell_grid(vtkDataSet* data, const Vectors& vectors,
                        const std::filesystem::path& path);

}  // namespace pellucid::fields
