// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkDataSet.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "fields/sampled/planar_field.h"

namespace pellucid::fields {

/// CheckedCells are volume cells that can be searched, and where they come from in a file's grid.
struct CheckedCells {
  vtkSmartPointer<vtkDataSet> cells;
  std::vector<vtkIdType> numbers;  // in the file, of each cell; empty: as they are
  /// Set when the file's cells lie on a plane, which prisms on both sides of it stand for: the
  /// file's points, moved to its one side, and all of them once more on the other.
  std::optional<Plane> plane;
  Box3 bounds;  // of the file's points, world units
};

/// Returns the types, by VTK's numbers, of the volume cells that can be searched.
std::span<const int> volume_cell_types();

/// Returns the volume cells of a grid, without those of lower dimension and those that it hides; of
/// a grid that has none the surface cells, where they lie on a plane. Throws InputError, naming
/// `path`, where a cell is of another kind, for fewer than two samples along two axes of a
/// structured grid, points that are not finite, surfaces that are no plane, and no cell at all.
CheckedCells checked_cells(vtkDataSet* data, const std::filesystem::path& path);

}  // namespace pellucid::fields
