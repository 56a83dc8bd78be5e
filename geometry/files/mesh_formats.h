// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One reader and one writer per file format; mesh_file.cpp picks by the file's ending.

#include <filesystem>
#include <string>
#include <string_view>

#include "geometry/line_set.h"
#include "geometry/point_set.h"
#include "geometry/triangle_mesh.h"

namespace pellucid::geometry {

TriangleMesh read_ply(const std::filesystem::path& path);
TriangleMesh read_obj(const std::filesystem::path& path);
TriangleMesh read_vtk_mesh(const std::filesystem::path& path);  // .vtp, .vtu, .vtk

LineSet read_ply_lines(const std::filesystem::path& path);
LineSet read_obj_lines(const std::filesystem::path& path);
LineSet read_vtk_lines(const std::filesystem::path& path);
LineSet read_binlines(const std::filesystem::path& path);

PointSet read_ply_points(const std::filesystem::path& path);
PointSet read_vtk_points(const std::filesystem::path& path);
PointSet read_csv_points(const std::filesystem::path& path);
PointSet read_vdb_points(const std::filesystem::path& path);

std::string encode_ply(const TriangleMesh& mesh);
std::string encode_obj(const TriangleMesh& mesh);
std::string encode_ply(const LineSet& lines);
std::string encode_obj(const LineSet& lines);
void write_vtp(const std::filesystem::path& path, const TriangleMesh& mesh);
void write_vtp(const std::filesystem::path& path, const LineSet& lines);

/// Vertex attributes by name, as a file holds them; `take_attributes` moves those with a meaning
/// (red green blue alpha importance nx ny nz) to where Vertices keep them.
using VertexAttributes = std::map<std::string, std::vector<double>>;
void take_attributes(VertexAttributes attributes, Vertices& vertices);

/// Throw InputError "FILE: …" for what read_mesh() promises to refuse.
void check_vertices(const std::string& file, const Vertices& vertices);
void check_mesh(const std::string& file, const TriangleMesh& mesh);

}  // namespace pellucid::geometry
