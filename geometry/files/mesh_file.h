// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "geometry/line_set.h"
#include "geometry/point_set.h"
#include "geometry/triangle_mesh.h"

namespace pellucid::geometry {

/// Reads triangles from .ply, .obj, .vtp, .vtu or legacy .vtk by the file's ending. Polygons become
/// triangle fans; of cells with a volume the faces on their boundary are taken.
/// Vertex attributes `red green blue alpha` (float as they are, 8-bit as n/255) fill `colors`,
/// `importance` fills `importance`, `nx ny nz` the normals; every other numeric vertex attribute
/// becomes a scalar of its name. Throws InputError for a file that is missing, truncated, without
/// triangles, or that holds a position that is not finite, an index out of range, or an opacity,
/// colour or importance outside [0, 1].
TriangleMesh read_mesh(const std::filesystem::path& path);

/// Reads polylines from .ply (consecutive vertices of equal `line` are joined; without that
/// attribute all of them), .obj (`l`), .vtp, .vtu, .vtk or .binlines. Attributes and refusals as
/// for read_mesh(); lines of fewer than two points are kept.
LineSet read_lines(const std::filesystem::path& path);

/// Reads the points of a .ply, .vtp, .vtu or .vtk file, where what joins them is left out, of a
/// .csv file whose first line names the columns, or of the point grids of an OpenVDB .vdb file.
PointSet read_points(const std::filesystem::path& path);

/// Writes .ply (binary, double positions, float attributes), .obj (positions, normals, triangles)
/// or .vtp. All scalars are kept by PLY and VTP. Throws InputError for another ending.
void write_mesh(const std::filesystem::path& path, const TriangleMesh& mesh);

/// Writes .vtp, .ply (vertices with their line's number) or .obj polylines.
void write_lines(const std::filesystem::path& path, const LineSet& lines);

}  // namespace pellucid::geometry
