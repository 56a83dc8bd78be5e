// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/line_set.h"
#include "geometry/triangle_mesh.h"

namespace pellucid::geometry {

/// Take away the vertices that no triangle has as a corner, or that no segment joins: nothing of
/// them is drawn, and they are no part of bounds and ranges. The others keep their order, and
/// lines their number. A line in the remarks says how many there were. What a file's `values`
/// holds is left.
///@{
void drop_unused_vertices(TriangleMesh& mesh);
void drop_unused_vertices(LineSet& lines);
///@}

}  // namespace pellucid::geometry
