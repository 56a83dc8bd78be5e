// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Tetrahedra and hexahedra are most of what unstructured grids hold: where a position is in them
// without VTK's cells. A cell is given by its arms, from the position to its corners in VTK's
// order, in world units: a cell far from the origin then loses no digits.

#include <array>

#include "core/vec.h"

namespace pellucid::fields {

/// Says whether the position is in a tetrahedron, its border among it but for roundings. Nothing is
/// in one without volume.
bool is_in_tetrahedron(const std::array<Vec3, 4>& arms);

/// Whether a position is in a cell: on a border it is inside, or so by rounding alone.
enum class Side { inside, outside, unsure };

/// Sets the parametric coordinates at which a hexahedron is at the position, by Newton's method
/// from its middle. Unsure is what does not end: in a hexahedron that is flat, or bent beyond
/// measure.
Side place_in_hexahedron(const std::array<Vec3, 8>& arms, Vec3& parametric);

/// Returns the weights of a hexahedron's corners, and their slopes along parametric coordinates.
///@{
std::array<double, 8> hexahedron_weights(const Vec3& parametric);
std::array<Vec3, 8> hexahedron_slopes(const Vec3& parametric);
///@}

}  // namespace pellucid::fields
