// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/triangle_mesh.h"

namespace pellucid::geometry {

/// Returns the area-weighted mean of the facets' normals around each vertex, of unit length.
/// Vertices of no facet with an area get +z.
std::vector<Vec3> facet_normals(const TriangleMesh& mesh);

/// Divides each normal by its length; one of length 0, or that is not finite, becomes (0, 0, 0),
/// which is none. Where normals are interpolated, longer ones would weigh more.
void make_unit(std::vector<Vec3>& normals);

/// Makes a mesh's normals unit, and gives facet_normals() to the vertices whose own is none: not
/// finite or of length 0. A mesh of such vertices alone has no normals then. Returns how many
/// vertices had none.
std::size_t mend_normals(TriangleMesh& mesh);

}  // namespace pellucid::geometry
