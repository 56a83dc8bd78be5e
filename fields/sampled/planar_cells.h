// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fields/sampled/cell_checks.h"

namespace pellucid::fields {

/// Says whether a cell of this VTK type is a surface that planar_cells() takes.
bool is_planar_type(int type);

/// Returns prisms that stand for the grid's surface cells, without those that it hides: wedges,
/// hexahedra, and for quadratic triangles wedges that are quadratic along the plane. Polygons and
/// strips are cut into triangles. Throws InputError, naming `path`, where there is no such cell and
/// for points off the plane. `bounds` are of the grid's points, which are finite.
CheckedCells planar_cells(vtkDataSet& data, const Box3& bounds, const std::filesystem::path& path);

}  // namespace pellucid::fields
