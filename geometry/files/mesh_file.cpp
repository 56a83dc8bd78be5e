// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/files/mesh_file.h"

#include <fmt/format.h>

#include "core/error.h"
#include "core/machine/build_info.h"
#include "geometry/files/color_names.h"
#include "geometry/files/mesh_formats.h"
#include "geometry/finite_vertices.h"
#include "geometry/vertex_normals.h"

namespace pellucid::geometry {
namespace {

namespace fs = std::filesystem;

/// The path's row when it has the function. Throws InputError that names the endings with one.
template <class Function>
const FormatRow& row_with(Function FormatRow::*function, const fs::path& path,
                          std::string_view kind) {
  const FormatRow* format = mesh_format(path);
  if (!format || !(format->*function))
    throw InputError(fmt::format("{}: unknown kind of {} file '{}'; accepted: {}", path.string(),
                                 kind, path.extension().string(), endings_with(function)));
  return *format;
}

void remark_normals(std::size_t none, std::size_t count, TriangleMesh& mesh) {
  if (none > 0)
    mesh.remarks.push_back(fmt::format(
        "{} of {} vertices have no normal of their own and get their facets'", none, count));
}

using Scalars = std::map<std::string, std::vector<double>>;

void remark_untaken_colors(const Scalars& scalars, Vertices& vertices) {
  std::vector<std::string> names;
  for (const auto& [name, values] : scalars) names.push_back(name);
  for (const std::string& name : untaken_colors(names))
    vertices.remarks.push_back(
        fmt::format("'{}' is called as colours are, and is read as scalars: {}", name,
                    vertices.colors.empty() ? "colours are bytes or numbers in [0, 1]"
                                            : "the colours are another array's"));
}

/// Colours, normals and the like are no scalars any more.
void keep_scalars_alone(const Scalars& faces, const Scalars& vertices, Scalars& values) {
  std::erase_if(values, [&](const auto& column) {
    return !faces.contains(column.first) && !vertices.contains(column.first);
  });
}

/// The version at the end, so that no backslash is there, which would go on with the next line.
std::string provenance(std::string_view origin) {
  constexpr std::size_t longest = 1000;  // characters: readers have buffers for a line
  const std::string version = fmt::format("pellucid {} ({})", build_version, build_commit);
  return origin.empty() ? version : fmt::format("{}; by {}", one_line(origin, longest), version);
}

}  // namespace

FileMesh read_mesh(const fs::path& path) {
  FileMesh mesh = row_with(&FormatRow::read_mesh, path, "mesh").read_mesh(path);
  check_mesh(path.string(), mesh);
  const std::size_t none = mend_normals(mesh);
  remark_normals(none, mesh.positions.size(), mesh);
  remark_untaken_colors(mesh.scalars, mesh);
  remark_untaken_colors(mesh.face_scalars, mesh);
  keep_scalars_alone(mesh.face_scalars, mesh.scalars, mesh.values);
  return mesh;
}

FileLines read_lines(const fs::path& path) {
  FileLines lines = row_with(&FormatRow::read_lines, path, "line").read_lines(path);
  check_vertices(path.string(), lines);
  make_unit(lines.normals);
  if (lines.segment_count() == 0) throw InputError(path.string() + ": the file holds no lines");
  remark_untaken_colors(lines.scalars, lines);
  keep_scalars_alone({}, lines.scalars, lines.values);
  return lines;
}

PointSet read_points(const fs::path& path) {
  PointSet points = row_with(&FormatRow::read_points, path, "point").read_points(path);
  check_vertices(path.string(), points);
  make_unit(points.normals);
  if (points.positions.empty()) throw InputError(path.string() + ": the file holds no points");
  remark_untaken_colors(points.scalars, points);
  return points;
}

void write_mesh(const fs::path& path, const TriangleMesh& mesh, std::string_view origin) {
  const FormatRow& row = row_with(&FormatRow::write_mesh, path, "mesh");
  check_finite(path.string(), mesh);
  row.write_mesh(path, mesh, provenance(origin));
}

void write_lines(const fs::path& path, const LineSet& lines, std::string_view origin) {
  const FormatRow& row = row_with(&FormatRow::write_lines, path, "line");
  check_finite(path.string(), lines);
  row.write_lines(path, lines, provenance(origin));
}

void write_points(const fs::path& path, const PointSet& points, std::string_view origin) {
  const FormatRow& row = row_with(&FormatRow::write_points, path, "point");
  check_finite(path.string(), points);
  row.write_points(path, points, provenance(origin));
}

}  // namespace pellucid::geometry
