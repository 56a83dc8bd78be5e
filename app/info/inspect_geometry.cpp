// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "app/info/inspect.h"
#include "app/info/vertices_contents.h"
#include "core/error.h"
#include "geometry/files/mesh_file.h"
#include "geometry/files/mesh_formats.h"
#include "geometry/unused_vertices.h"

namespace pellucid::app {
namespace {

template <class Vector>
void add_vectors(const char* name, const char* type, const std::vector<Vector>& vectors,
                 FileContents& contents) {
  if (vectors.empty()) return;
  constexpr int components = Vector::length();
  RangeCollector ranges(components);
  for (const Vector& v : vectors)
    for (int c = 0; c < components; ++c) ranges.add(std::size_t(c), v[c]);
  contents.arrays.push_back(ranges.contents(name, "point", type, vectors.size()));
}

template <class Number>
void add_numbers(const std::string& name, const char* at, const char* type,
                 const std::vector<Number>& numbers, FileContents& contents) {
  if (numbers.empty()) return;
  RangeCollector ranges(1);
  for (const Number number : numbers) ranges.add(0, double(number));
  contents.arrays.push_back(ranges.contents(name, at, type, numbers.size()));
}

/// Bounds are of what is drawn; counts and ranges are of all that the file holds.
template <class Shape>
void tell_unused(Shape shape, FileContents& contents) {
  geometry::drop_unused_vertices(shape);
  contents.bounds = shape.bounds();
  if (!shape.remarks.empty()) contents.more["remarks"] = shape.remarks;
}

FileContents contents_of(geometry::TriangleMesh mesh) {
  FileContents contents;
  contents.kind = "triangles";
  contents.counts = {{"points", mesh.positions.size()}, {"triangles", mesh.triangles.size()}};
  add_vertices(mesh, contents);
  tell_unused(std::move(mesh), contents);
  return contents;
}

FileContents contents_of(geometry::LineSet lines) {
  FileContents contents;
  contents.kind = "lines";
  contents.counts = {{"points", lines.positions.size()},
                     {"lines", lines.line_count()},
                     {"segments", lines.segment_count()}};
  add_vertices(lines, contents);
  tell_unused(std::move(lines), contents);
  return contents;
}

FileContents contents_of(const geometry::PointSet& points) {
  FileContents contents;
  contents.kind = "points";
  contents.counts = {{"points", points.positions.size()}};
  add_vertices(points, contents);
  return contents;
}

/// What the first of its readers that finds something makes of it. All complain of a file that is
/// damaged: then the first one is heard.
FileContents first_found(const std::filesystem::path& path, const geometry::FormatRow& row) {
  std::optional<InputError> complaint;
  const auto attempt = [&](bool has_reader, const auto& read) -> std::optional<FileContents> {
    if (!has_reader) return std::nullopt;
    try {
      return contents_of(read(path));
    } catch (const InputError& error) {
      if (!complaint) complaint = error;
      return std::nullopt;
    }
  };
  if (auto mesh = attempt(row.read_mesh, geometry::read_mesh)) return std::move(*mesh);
  if (auto lines = attempt(row.read_lines, geometry::read_lines)) return std::move(*lines);
  if (auto points = attempt(row.read_points, geometry::read_points)) return std::move(*points);
  throw InputError(complaint->what());
}

}  // namespace

void add_vertices(const geometry::Vertices& vertices, FileContents& contents) {
  contents.bounds = vertices.bounds();
  add_vectors("normals", "double", vertices.normals, contents);
  add_vectors("colors", "float", vertices.colors, contents);
  add_numbers("importance", "point", "float", vertices.importance, contents);
  for (const auto& [name, values] : vertices.scalars)
    add_numbers(name, "point", "double", values, contents);
  if (!vertices.remarks.empty()) contents.more["remarks"] = vertices.remarks;
}

FileContents inspect_geometry(const std::filesystem::path& path) {
  const geometry::FormatRow& row = *geometry::mesh_format(path);
  FileContents contents = first_found(path, row);
  contents.title = row.title;
  return contents;
}

}  // namespace pellucid::app
