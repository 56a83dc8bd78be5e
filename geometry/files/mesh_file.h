// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string_view>

#include "geometry/files/from_file.h"
#include "geometry/point_set.h"

namespace pellucid::geometry {

/// Reads triangles by the file's ending, which mesh_formats() lists. Polygons become the
/// triangles of triangulate_polygon(); of cells with a volume the faces on their boundary are
/// taken. Vertex attributes `red green blue alpha` (float as they are, 8-bit as n/255) fill
/// `colors`, `importance` fills `importance`, `nx ny nz` the normals; every other numeric vertex
/// attribute becomes a scalar of its name. Normals are made unit. One of length 0 or that is not
/// finite is none: its vertex gets the mean of its facets', and the remarks say how many did; what
/// is called as colours are and was not taken for one is in the remarks, too. In .obj every pair of
/// position and normal is a vertex. Throws InputError for a file that is missing, truncated,
/// without triangles, or that holds a position that is not finite, an index out of range, or an
/// opacity, colour or importance outside [0, 1].
FileMesh read_mesh(const std::filesystem::path& path);

/// Reads polylines. In .ply consecutive vertices of equal `line` are joined, else those of an
/// element `edge`; without either there are no lines. Attributes and refusals as for read_mesh();
/// lines of fewer than two points are kept.
FileLines read_lines(const std::filesystem::path& path);

/// Reads points; what joins them in a file of triangles or lines is left out. The first line of a
/// .csv file names its columns; of a .vdb file the point grids are read.
PointSet read_points(const std::filesystem::path& path);

/// Writes by the file's ending: .ply is binary with double positions and float attributes, .obj
/// holds positions, normals and triangles. All scalars are kept by PLY and VTP. The file says in a
/// comment, VTK's in the string array "origin" of its field data, by which version it was written
/// and the `origin`, such as a command. Throws InputError for an ending without a writer, and for a
/// position that is not finite.
void write_mesh(const std::filesystem::path& path, const TriangleMesh& mesh,
                std::string_view origin = {});

/// Does so with polylines; in .ply each vertex has its line's number.
void write_lines(const std::filesystem::path& path, const LineSet& lines,
                 std::string_view origin = {});

/// Does so with points; .ply has them as the vertices of a mesh without triangles.
void write_points(const std::filesystem::path& path, const PointSet& points,
                  std::string_view origin = {});

}  // namespace pellucid::geometry
