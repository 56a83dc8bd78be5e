// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/triangle_mesh.h"

namespace pellucid::geometry {

/// Gives each triangle one colour, `colors` has as many, in the place of the vertices'. A vertex of
/// triangles of several colours becomes one vertex for each; those of no triangle are left out.
void color_faces(const std::vector<Rgba>& colors, TriangleMesh& mesh);

}  // namespace pellucid::geometry
