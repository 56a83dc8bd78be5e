// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkDataArray.h>
#include <vtkSmartPointer.h>

class vtkDataSet;

namespace pellucid::fields {

/// Returns an array of the points: at each the mean over the cells around it, all weighing the
/// same, as VTK's and ParaView's "cell data to point data" have it. On even spacing that is exact
/// for linear data but for the points of the border, whose mean is one-sided: it is off by half a
/// cell's change. Cells count that are not hidden and have the highest dimension of all: the faces
/// of a boundary say nothing of the volume. Points without such a cell get NaN. `of_cells` has a
/// tuple per cell.
vtkSmartPointer<vtkDataArray> averaged_to_points(vtkDataSet& data, vtkDataArray& of_cells);

}  // namespace pellucid::fields
