// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "geometry/files/mesh_formats.h"
#include "geometry/line_set.h"

namespace pellucid::geometry {

/// Edges become lines of two points; one that starts where the one before ended goes on with its
/// line, unless the edges have numbers of their own. Those, such as colours, go to both points; the
/// vertices have none of their names. Throws InputError that begins with `file` for edges without
/// ends, or beyond the vertices.
void join_by_edges(VertexAttributes edges, const std::string& file, LineSet& lines,
                   VertexAttributes& attributes);

/// Joins consecutive vertices of equal `line`.
void join_by_number(const std::vector<double>& line, LineSet& lines);

}  // namespace pellucid::geometry
