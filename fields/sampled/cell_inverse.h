// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/vec.h"

class vtkGenericCell;

namespace pellucid::fields {

/// Returns the parametric coordinates at which a volume cell is at x, in world units, or nothing
/// where x is farther from it than edge_rounding of the cell's diagonal. Where the cell's map takes
/// several coordinates to x, as on the edge that faces of a hexahedron have collapsed to, it is one
/// of them.
std::optional<Vec3> place_in_cell(vtkGenericCell& cell, const Vec3& x);

}  // namespace pellucid::fields
