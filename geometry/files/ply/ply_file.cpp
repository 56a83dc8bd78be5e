// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/files/output_file.h"
#include "core/files/pages.h"
#include "geometry/default_color.h"
#include "geometry/files/face_colors.h"
#include "geometry/files/mesh_formats.h"
#include "geometry/files/ply/ply_columns.h"
#include "geometry/files/ply/ply_lines.h"
#include "geometry/files/ply/ply_writer.h"
#include "geometry/files/splats.h"
#include "geometry/polygons/triangulate.h"

namespace pellucid::geometry {
namespace {

VertexAttributes read_vertices(ply::Reader& reader, const ply::Element& element,
                               Vertices& vertices) {
  VertexAttributes attributes = ply::read_columns(reader, element);
  for (const char* axis : {"x", "y", "z"})
    if (!attributes.contains(axis))
      throw InputError(
          fmt::format("{}: element 'vertex' has no property '{}'", reader.where(), axis));
  const auto x = attributes.extract("x"), y = attributes.extract("y"), z = attributes.extract("z");
  reserve_in_huge_pages(vertices.positions, element.count);
  vertices.positions.resize(element.count);
  for (std::uint64_t i = 0; i < element.count; ++i)
    vertices.positions[i] = {x.mapped()[i], y.mapped()[i], z.mapped()[i]};
  return attributes;
}

bool is_corners(const ply::Property& property) {
  return property.name == "vertex_indices" || property.name == "vertex_index";
}

std::uint32_t checked_index(const ply::Reader& reader, double index, std::uint64_t face,
                            std::size_t vertex_count) {
  if (!(index >= 0 && index < double(vertex_count)) || index != std::uint32_t(index))
    throw InputError(fmt::format("{}: face {}: vertex index {}, but the file has {} vertices",
                                 reader.where(), face, index, vertex_count));
  return static_cast<std::uint32_t>(index);
}

std::uint32_t read_index(ply::Reader& reader, ply::Type type, std::uint64_t face,
                         std::size_t vertex_count) {
  return checked_index(reader, reader.next(type), face, vertex_count);
}

void read_polygon(ply::Reader& reader, const ply::Property& property, std::uint64_t face,
                  TriangleMesh& mesh) {
  const std::uint64_t count = ply::list_length(reader, property);
  std::vector<std::uint32_t> corners;
  for (std::uint64_t k = 0; k < count; ++k)
    corners.push_back(read_index(reader, property.type, face, mesh.positions.size()));
  triangulate_polygon(mesh.positions, corners, mesh.triangles);
}

constexpr std::uint64_t no_face = ~std::uint64_t(0);

/// Numbers of faces by name, and each triangle's face: no_face of those in strips.
struct FaceNumbers {
  VertexAttributes values;
  std::vector<std::uint64_t> faces;
};

FaceNumbers read_faces(ply::Reader& reader, const ply::Element& element, TriangleMesh& mesh) {
  FaceNumbers numbers;
  numbers.faces.assign(mesh.triangles.size(), no_face);
  ply::Columns columns(element);
  mesh.triangles.reserve(element.count);
  for (std::uint64_t i = 0; i < element.count; ++i) {
    for (std::size_t k = 0; k < element.properties.size(); ++k) {
      const ply::Property& property = element.properties[k];
      if (!property.is_list)
        columns.read(reader, property, k);
      else if (is_corners(property))
        read_polygon(reader, property, i, mesh);
      else
        ply::skip(reader, property);
    }
    numbers.faces.resize(mesh.triangles.size(), i);
  }
  numbers.values = columns.take();
  return numbers;
}

/// Takes the colours of triangles out of their numbers; those of strips have none.
void take_face_colors(const std::vector<std::uint64_t>& faces, VertexAttributes& of_triangles,
                      FileMesh& mesh) {
  FaceColors own;
  own.have_alpha = of_triangles.contains("alpha");
  if (!has_rgb(of_triangles) && !mesh.colors.empty()) return;
  own.colors = take_colors(of_triangles, mesh.triangles.size());
  if (own.colors.empty()) return;
  for (std::size_t i = 0; i < faces.size(); ++i)
    if (faces[i] == no_face) own.colors[i] = Rgba(default_color, 1);
  color_faces(own, mesh);
}

/// Colours are those of faces where the vertices have none, or an alpha alone; all other numbers
/// are scalars. `colored` says whether the vertices have red, green and blue.
void take_face_numbers(FaceNumbers numbers, bool colored, FileMesh& mesh) {
  numbers.faces.resize(mesh.triangles.size(), no_face);
  VertexAttributes of_triangles;
  for (const auto& [name, values] : numbers.values) {
    std::vector<double>& column = of_triangles[name];
    column.reserve(mesh.triangles.size());
    for (const std::uint64_t face : numbers.faces)
      column.push_back(face == no_face ? NAN : values[face]);
  }
  if (!colored) take_face_colors(numbers.faces, of_triangles, mesh);
  mesh.face_scalars = std::move(of_triangles);
  take_face_values(std::move(numbers.values), mesh);
}

/// Strips of triangles, one after another in a list; -1 begins the next one. Every other triangle
/// of a strip is turned round, so that all face the same way.
void read_strip(ply::Reader& reader, const ply::Property& property, std::uint64_t row,
                TriangleMesh& mesh) {
  const std::uint64_t count = ply::list_length(reader, property);
  std::vector<std::uint32_t> strip;
  for (std::uint64_t k = 0; k < count; ++k) {
    const double index = reader.next(property.type);
    if (index == -1) {
      strip.clear();
      continue;
    }
    strip.push_back(checked_index(reader, index, row, mesh.positions.size()));
    const std::size_t n = strip.size();
    if (n < 3) continue;
    const bool odd = n % 2 == 0;
    mesh.triangles.push_back({strip[n - 3 + odd], strip[n - 2 - odd], strip[n - 1]});
  }
}

void read_strips(ply::Reader& reader, const ply::Element& element, TriangleMesh& mesh) {
  for (std::uint64_t i = 0; i < element.count; ++i)
    for (const ply::Property& property : element.properties)
      if (property.is_list && is_corners(property))
        read_strip(reader, property, i, mesh);
      else
        ply::skip(reader, property);
}

/// Calls `read(element, reader)` for each element but the vertices, whose positions it fills
/// before; what `read` returns false for is passed over. Elements may stand before the vertices.
template <class Read>
VertexAttributes read_elements(const std::filesystem::path& path, Vertices& vertices,
                               const Read& read) {
  const std::string content = read_text(path);
  ply::Reader reader(path.string(), without_mark(content));
  VertexAttributes attributes;
  const std::vector<ply::Element> elements = reader.read_header().elements;
  std::vector<std::pair<const ply::Element*, ply::Reader>> before;
  bool has_vertices = std::ranges::find(elements, "vertex", &ply::Element::name) == elements.end();
  for (const ply::Element& element : elements) {
    ply::check_count(reader, element);
    if (element.name == "vertex") {
      attributes = read_vertices(reader, element, vertices);
      has_vertices = true;
      for (auto& [earlier, at] : before) read(*earlier, at);
    } else if (!has_vertices) {
      before.emplace_back(&element, reader);
      ply::skip(reader, element);
    } else if (!read(element, reader)) {
      ply::skip(reader, element);
    }
  }
  return attributes;
}

constexpr auto nothing_else = [](const ply::Element&, ply::Reader&) { return false; };

FileMesh read_ply(const std::filesystem::path& path) {
  FileMesh mesh;
  FaceNumbers numbers;
  auto attributes =
      read_elements(path, mesh, [&](const ply::Element& element, ply::Reader& reader) {
        if (element.name != "face" && element.name != "tristrips") return false;
        if (element.name == "face")
          numbers = read_faces(reader, element, mesh);
        else
          read_strips(reader, element, mesh);
        return true;
      });
  const bool colored = has_rgb(attributes);
  take_attributes(std::move(attributes), mesh);
  take_face_numbers(std::move(numbers), colored, mesh);
  return mesh;
}

FileLines read_ply_lines(const std::filesystem::path& path) {
  FileLines lines;
  std::optional<VertexAttributes> edges;
  VertexAttributes attributes =
      read_elements(path, lines, [&](const ply::Element& element, ply::Reader& reader) {
        if (element.name != "edge") return false;
        edges = ply::read_columns(reader, element);
        return true;
      });
  const auto line = attributes.extract("line");
  if (line)
    join_by_number(line.mapped(), lines);
  else if (edges) {
    for (const auto& [name, column] : attributes) edges->erase(name);
    lines.values = attributes;
    lines.values.insert(edges->begin(), edges->end());
    join_by_edges(std::move(*edges), path.string(), lines, attributes);
  } else
    throw InputError(path.string() +
                     ": the file holds no lines; expected an element 'edge' with vertex1 and "
                     "vertex2, or a property 'line' of its vertices, which numbers their lines");
  take_attributes(std::move(attributes), lines);
  return lines;
}

PointSet read_ply_points(const std::filesystem::path& path) {
  PointSet points;
  VertexAttributes attributes = read_elements(path, points, nothing_else);
  if (are_splats(attributes)) take_splats(attributes);
  take_attributes(std::move(attributes), points);
  return points;
}

}  // namespace

FormatRow ply_format() {
  return {
      .ending = ".ply",
      .title = "Stanford polygon file, text or binary",
      .traps =
          "colours and other numbers of faces are flat; lines by edges or by the property line; "
          "Gaussian splats are balls of their peak "
          "opacity, their size the scalar radius",
      .read_mesh = read_ply,
      .read_lines = read_ply_lines,
      .read_points = read_ply_points,
      .write_mesh = write_ply,
      .write_lines = write_ply_lines,
      .write_points = write_ply_points};
}

}  // namespace pellucid::geometry
