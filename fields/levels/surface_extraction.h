// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "fields/levels/level_field.h"

namespace pellucid::fields {

/// An ExtractedSurface holds triangles on an isosurface of a field on levels.
struct ExtractedSurface {
  std::vector<Vec3> positions;                          // world
  std::vector<Vec3> normals;                            // unit gradients
  std::vector<std::array<std::uint32_t, 3>> triangles;  // indices of vertices, from 0
};

/// Extracts the surface where the field takes `value`, as triangles: marching cubes (VTK's flying
/// edges) over samples of the reconstruction as far apart as those of the finest level, wherever
/// the field is defined; vertices are then moved along the gradient onto the surface. Vertices lie
/// on the surface but where a reconstruction jumps across the value; between them triangles err in
/// order 2 of the finest cell. The surface is open at the field's end; up to a cell is missing
/// where that is within its bounds. Throws InputError when the field's bounds hold more than 2^28
/// such samples.
ExtractedSurface extract_surface(const LevelField& field, double value);

}  // namespace pellucid::fields
