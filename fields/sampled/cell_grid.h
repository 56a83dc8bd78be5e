// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkDataSet.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <vector>

#include "core/vec.h"

class vtkDataArray;
class vtkGenericCell;

namespace pellucid::fields {

/// A CellGrid holds volume cells with a velocity at each point: checked, so that VTK can search
/// them safely. Positions are in world coordinates.
struct CellGrid {
  static constexpr int largest_cell = 27;  // most points of a cell that is accepted

  vtkSmartPointer<vtkDataSet> cells;
  std::vector<Vec3> velocities;  // by point, world units per unit of time
  Box3 bounds;

  Vec3 point(vtkIdType number) const;
  const Vec3& velocity(vtkIdType point) const { return velocities[std::size_t(point)]; }

  /// Slopes say how positions and velocities change with a cell's parametric coordinates: column k
  /// by the k-th.
  struct Slopes {
    Mat3 position, velocity;
  };
  Slopes slopes(vtkGenericCell& cell, const double parametric[3]) const;

  /// Returns the Jacobian of the cell's interpolant, per unit of time; column j is the derivative
  /// along axis j. It is infinite where the cell is flat.
  Mat3 jacobian(vtkGenericCell& cell, const double parametric[3]) const;

  /// Returns the smallest width of all cells, in world units: a cell's width is the diagonal of its
  /// box over √3, a cube's edge. Slivers do not count as thin, since they say little about how
  /// finely a flow was sampled.
  double smallest_width() const;

  /// Estimates the largest difference between interpolant and sampled field, in world units per
  /// unit of time: half of
  /// |(mean Jacobian of the cells around a node - the cell's own there) (node - cell's centre)|.
  /// In one dimension with even spacing h that is h²/8 |f''|, the error of straight lines: the
  /// Jacobians differ by h f''/2 and the centre is h/2 away. (The gradient recovery of O. C.
  /// Zienkiewicz and J. Z. Zhu, Int. J. Numer. Meth. Engng. 24 (1987).)
  double sampling_error() const;
};

/// Checks the cells of `data` and copies the velocities of its points. Throws InputError, naming
/// `path`, for connectivity that points nowhere, cells that cannot be searched, no volume cell, and
/// points that are not finite.
CellGrid make_cell_grid(vtkDataSet* data, vtkDataArray* vectors, const std::filesystem::path& path);

}  // namespace pellucid::fields
