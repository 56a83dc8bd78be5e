// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "geometry/line_set.h"
#include "geometry/point_set.h"
#include "geometry/triangle_mesh.h"

namespace pellucid::geometry {

/// Writes a binary PLY file, positions and scalars in double, colours and importance in float.
/// The `origin`, a line of text, is a comment. Lines are numbered by the property `line` of their
/// vertices, and have their edges besides. Throws WorkError where the file cannot be written.
///@{
void write_ply(const std::filesystem::path& path, const TriangleMesh& mesh,
               const std::string& origin);
void write_ply_lines(const std::filesystem::path& path, const LineSet& lines,
                     const std::string& origin);
void write_ply_points(const std::filesystem::path& path, const PointSet& points,
                      const std::string& origin);
///@}

}  // namespace pellucid::geometry
