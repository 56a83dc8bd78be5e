// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkSmartPointer.h>

#include "geometry/files/from_file.h"
#include "geometry/point_set.h"

class vtkDataSet;

namespace pellucid::geometry {

/// Returns the triangles of the data's polygons and strips or, of other data, of the faces that
/// bound its cells, with the numbers of the cells as face_scalars; what the data hide is left out.
/// Every index of the data has to be that of a point (readers/vtk/cell_rules.h).
FileMesh mesh_of(const vtkSmartPointer<vtkDataSet>& data);

/// Returns the data's polylines in the same way.
FileLines lines_of(const vtkSmartPointer<vtkDataSet>& data);

/// Returns the points that the data show.
PointSet points_of(const vtkSmartPointer<vtkDataSet>& data);

}  // namespace pellucid::geometry
