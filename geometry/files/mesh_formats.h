// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The kinds of file that geometry is kept in: one row each, which its own source file makes and
// mesh_formats.cpp lists.

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/files/from_file.h"
#include "geometry/point_set.h"

namespace pellucid::geometry {

/// One kind of file. What it cannot hold has no reader, and what is not written no writer. A writer
/// gets a line on where the geometry is from, without control characters or a backslash at its end,
/// which it keeps where the kind has a place for it.
struct FormatRow {
  std::string_view ending;  // ".ply", in small letters
  std::string_view title;
  std::string_view traps = {};  // what a user has to know, for people
  FileMesh (*read_mesh)(const std::filesystem::path&) = nullptr;
  FileLines (*read_lines)(const std::filesystem::path&) = nullptr;
  PointSet (*read_points)(const std::filesystem::path&) = nullptr;
  void (*write_mesh)(const std::filesystem::path&, const TriangleMesh&,
                     const std::string&) = nullptr;
  void (*write_lines)(const std::filesystem::path&, const LineSet&, const std::string&) = nullptr;
  void (*write_points)(const std::filesystem::path&, const PointSet&, const std::string&) = nullptr;
  bool writes_scalars = true;  // what is written has the vertices' numbers
};

/// Returns the table of formats.
std::span<const FormatRow> mesh_formats();

/// The format that the path ends as, in small or capital letters; nothing when there is none.
const FormatRow* mesh_format(const std::filesystem::path& path);

/// ".ply, .obj, …": the endings of the formats that have such a reader or writer.
template <class Function>
std::string endings_with(Function FormatRow::*function) {
  std::string endings;
  for (const FormatRow& format : mesh_formats()) {
    if (!(format.*function)) continue;
    if (!endings.empty()) endings += ", ";
    endings += format.ending;
  }
  return endings;
}

/// VertexAttributes are numbers of the vertices by their name, as a file holds them.
using VertexAttributes = std::map<std::string, std::vector<double>>;

/// Says whether red, green and blue are among the attributes.
bool has_rgb(const VertexAttributes& attributes);

/// Moves the attributes with a meaning (red green blue alpha importance nx ny nz) to where Vertices
/// keep them, and the others to the scalars.
void take_attributes(VertexAttributes attributes, Vertices& vertices);

/// Takes the colours of `count` vertices or faces out of their attributes: red green blue, else
/// those of default_color, with alpha, else 1. Without any of these there are none.
std::vector<Rgba> take_colors(VertexAttributes& attributes, std::size_t count);

/// Throws InputError "FILE: …" for what read_mesh() promises to refuse.
///@{
void check_vertices(const std::string& file, const Vertices& vertices);
void check_mesh(const std::string& file, const TriangleMesh& mesh);
///@}

}  // namespace pellucid::geometry
