// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "oit/shapes/clipped_triangles.h"

namespace pellucid::oit {

/// Clips the triangles of all meshes, or of all ribbons, to the guard band of the `view`. Throws
/// InputError as TriangleClipper::clip().
///@{
ClippedTriangles clip_meshes(const scene::Scene& scene, const ViewSpace& view);
ClippedTriangles clip_ribbons(const scene::Scene& scene, const ViewSpace& view);
///@}

}  // namespace pellucid::oit
