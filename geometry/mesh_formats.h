#pragma once
// One reader and one writer per file format; mesh_file.cpp picks by the file's ending.

#include <filesystem>
#include <string>
#include <string_view>

#include "geometry/line_set.h"
#include "geometry/triangle_mesh.h"

namespace pellucid {

TriangleMesh read_ply(const std::filesystem::path& path);
TriangleMesh read_obj(const std::filesystem::path& path);
TriangleMesh read_vtp(const std::filesystem::path& path);

std::string encode_ply(const TriangleMesh& mesh);
std::string encode_obj(const TriangleMesh& mesh);
std::string encode_ply(const LineSet& lines);
std::string encode_obj(const LineSet& lines);
void write_vtp(const std::filesystem::path& path, const TriangleMesh& mesh);
void write_vtp(const std::filesystem::path& path, const LineSet& lines);

/// Vertex attributes by name, as a file holds them; `take_attributes` moves those with a meaning
/// (red green blue alpha importance nx ny nz) to where TriangleMesh keeps them.
using VertexAttributes = std::map<std::string, std::vector<double>>;
void take_attributes(VertexAttributes attributes, TriangleMesh& mesh);

/// Throws InputError "FILE: …" for what read_mesh() promises to refuse.
void check_mesh(const std::string& file, const TriangleMesh& mesh);

}  // namespace pellucid
