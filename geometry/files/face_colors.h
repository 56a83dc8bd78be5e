// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/files/from_file.h"

namespace pellucid::geometry {

/// Gives each triangle one colour, `colors` has as many, in the place of the vertices'. A vertex of
/// triangles of several colours becomes one vertex for each; those of no triangle are left out. The
/// scalars of the vertices as they were become the file's `values`.
void color_faces(const std::vector<Rgba>& colors, FileMesh& mesh);

}  // namespace pellucid::geometry
