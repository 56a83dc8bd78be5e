// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/info/contents.h"
#include "geometry/vertices.h"

namespace pellucid::app {

/// Sets the bounds and adds an array for each thing that the vertices carry: the scalars by their
/// names, `normals`, `colors` (red, green, blue, alpha) and `importance`.
void add_vertices(const geometry::Vertices& vertices, FileContents& contents);

}  // namespace pellucid::app
