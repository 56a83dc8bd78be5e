// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What VTK's array vtkGhostType says of cells and points: the flags DUPLICATECELL (another piece
// has the cell), HIDDENCELL and HIDDENPOINT (they are there for the numbering alone).

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <vector>

class vtkDataSet;

namespace pellucid::readers {

/// Says whether the data mark any cell as hidden or duplicated, or any point as hidden.
bool hides_cells(vtkDataSet* data);

/// Says whether a cell is marked as hidden or duplicated, or a corner of it as hidden; the cell's
/// number is below the number of cells.
bool hides_cell(vtkDataSet* data, vtkIdType cell);

/// Says whether a point is marked as hidden; its number is below the number of points.
bool hides_point(vtkDataSet* data, vtkIdType point);

/// Returns the cells that are not hidden, as an unstructured grid with all points, under their
/// numbers, and all arrays but the marks. Indices are those of points: data_set_of() has seen to
/// it. `numbers`, where given, gets the number in `data` of each cell.
vtkSmartPointer<vtkDataSet> shown_cells(vtkDataSet* data,
                                        std::vector<vtkIdType>* numbers = nullptr);

}  // namespace pellucid::readers
