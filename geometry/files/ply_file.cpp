// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/error.h"
#include "core/files/output_file.h"
#include "geometry/files/color_names.h"
#include "geometry/files/mesh_formats.h"
#include "geometry/files/ply_format.h"
#include "geometry/files/ply_writer.h"
#include "geometry/files/splats.h"
#include "geometry/polygons/triangulate.h"

namespace pellucid::geometry {
namespace {

/// 8- and 16-bit colours count in steps of 1/255 and 1/65535; anything else is used as it stands.
double color_scale(ply::Type type) {
  if (type == ply::Type::uint8) return 255;
  if (type == ply::Type::uint16) return 65535;
  return 1;
}

/// Nothing that a header claims sizes an allocation unchecked: every value takes at least one byte.
void check_count(const ply::Reader& reader, const ply::Element& element) {
  if (!element.properties.empty() &&
      element.count > reader.bytes_left() / element.properties.size())
    throw InputError(fmt::format("{}: the header declares {} × '{}', but only {} bytes follow",
                                 reader.where(), element.count, element.name, reader.bytes_left()));
}

/// The length of a list, which a file may write as any number type: as many entries as 0, 1, … stay
/// below it. The reader throws long before a length that no file holds.
std::uint64_t list_length(ply::Reader& reader, const ply::Property& property) {
  constexpr double most = 1e18;
  const double length = std::ceil(reader.next(property.count_type));
  return length > 0 ? std::uint64_t(std::min(length, most)) : 0;
}

void skip(ply::Reader& reader, const ply::Property& property) {
  const std::uint64_t count = property.is_list ? list_length(reader, property) : 1;
  for (std::uint64_t i = 0; i < count; ++i) reader.next(property.type);
}

void skip(ply::Reader& reader, const ply::Element& element) {
  for (std::uint64_t i = 0; i < element.count; ++i)
    for (const ply::Property& property : element.properties) skip(reader, property);
}

/// The numbers of all records of an element, by name. Colours go by their channels.
VertexAttributes read_columns(ply::Reader& reader, const ply::Element& element) {
  std::vector<std::string> names;
  for (const ply::Property& property : element.properties)
    if (!property.is_list) names.push_back(property.name);
  const auto channels = color_channels(names);
  VertexAttributes attributes;
  struct Column {
    std::vector<double>* values = nullptr;  // none: of a list
    double scale = 1;
  };
  std::vector<Column> columns;
  for (const ply::Property& property : element.properties) {
    const auto channel = channels.find(property.name);
    const bool is_color = channel != channels.end();
    columns.push_back(
        {property.is_list ? nullptr : &attributes[is_color ? channel->second : property.name],
         is_color ? color_scale(property.type) : 1});
    if (columns.back().values) columns.back().values->reserve(element.count);
  }
  for (std::uint64_t i = 0; i < element.count; ++i)
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const ply::Property& property = element.properties[k];
      if (columns[k].values)
        columns[k].values->push_back(reader.next(property.type) / columns[k].scale);
      else
        skip(reader, property);
    }
  return attributes;
}

VertexAttributes read_vertices(ply::Reader& reader, const ply::Element& element,
                               Vertices& vertices) {
  VertexAttributes attributes = read_columns(reader, element);
  for (const char* axis : {"x", "y", "z"})
    if (!attributes.contains(axis))
      throw InputError(
          fmt::format("{}: element 'vertex' has no property '{}'", reader.where(), axis));
  const auto x = attributes.extract("x"), y = attributes.extract("y"), z = attributes.extract("z");
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
  const std::uint64_t count = list_length(reader, property);
  std::vector<std::uint32_t> corners;
  for (std::uint64_t k = 0; k < count; ++k)
    corners.push_back(read_index(reader, property.type, face, mesh.positions.size()));
  triangulate_polygon(mesh.positions, corners, mesh.triangles);
}

void read_faces(ply::Reader& reader, const ply::Element& element, TriangleMesh& mesh) {
  mesh.triangles.reserve(element.count);
  for (std::uint64_t i = 0; i < element.count; ++i)
    for (const ply::Property& property : element.properties) {
      if (property.is_list && is_corners(property))
        read_polygon(reader, property, i, mesh);
      else
        skip(reader, property);
    }
}

/// Strips of triangles, one after another in a list; -1 begins the next one. Every other triangle
/// of a strip is turned round, so that all face the same way.
void read_strip(ply::Reader& reader, const ply::Property& property, std::uint64_t row,
                TriangleMesh& mesh) {
  const std::uint64_t count = list_length(reader, property);
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
        skip(reader, property);
}

/// Calls `read(element, reader)` for each element after the vertices, whose positions it fills;
/// what `read` returns false for is passed over.
template <class Read>
VertexAttributes read_elements(const std::filesystem::path& path, Vertices& vertices,
                               const Read& read) {
  const std::string content = read_text(path);
  ply::Reader reader(path.string(), without_mark(content));
  VertexAttributes attributes;
  for (const ply::Element& element : reader.read_header().elements) {
    check_count(reader, element);
    if (element.name == "vertex")
      attributes = read_vertices(reader, element, vertices);
    else if (!read(element, reader))
      skip(reader, element);
  }
  return attributes;
}

constexpr auto nothing_else = [](const ply::Element&, ply::Reader&) { return false; };

TriangleMesh read_ply(const std::filesystem::path& path) {
  TriangleMesh mesh;
  auto attributes =
      read_elements(path, mesh, [&](const ply::Element& element, ply::Reader& reader) {
        if (element.name == "face") read_faces(reader, element, mesh);
        if (element.name == "tristrips") read_strips(reader, element, mesh);
        return element.name == "face" || element.name == "tristrips";
      });
  take_attributes(std::move(attributes), mesh);
  return mesh;
}

/// Puts the points of `order`, one after another, in the place of the vertices.
void reorder(const std::vector<std::uint32_t>& order, Vertices& vertices,
             VertexAttributes& attributes) {
  const auto pick = [&](auto& values) {
    std::remove_reference_t<decltype(values)> picked;
    picked.reserve(order.size());
    for (const std::uint32_t i : order) picked.push_back(values[i]);
    values = std::move(picked);
  };
  pick(vertices.positions);
  for (auto& [name, values] : attributes) pick(values);
}

std::uint32_t end_of_edge(const std::vector<double>& ends, std::size_t edge, std::size_t vertices,
                          const std::string& file) {
  const double end = ends[edge];
  if (!(end >= 0 && end < double(vertices)) || end != std::uint32_t(end))
    throw InputError(fmt::format("{}: edge {}: vertex index {}, but the file has {} vertices", file,
                                 edge, end, vertices));
  return std::uint32_t(end);
}

/// Edges become lines of two points; one that starts where the one before ended goes on with its
/// line, unless the edges have numbers of their own. Those, such as colours, go to both points, in
/// the place of the vertices' of that name.
void join_by_edges(VertexAttributes edges, const std::string& file, LineSet& lines,
                   VertexAttributes& attributes) {
  const auto first = edges.extract("vertex1"), second = edges.extract("vertex2");
  if (!first || !second)
    throw InputError(file + ": element 'edge': expected properties vertex1 and vertex2");
  std::vector<std::uint32_t> order;
  for (std::size_t i = 0; i < first.mapped().size(); ++i) {
    const std::size_t count = lines.positions.size();
    const std::uint32_t from = end_of_edge(first.mapped(), i, count, file);
    const std::uint32_t to = end_of_edge(second.mapped(), i, count, file);
    if (order.empty() || order.back() != from || !edges.empty()) {
      if (!order.empty()) lines.offsets.push_back(order.size());
      order.push_back(from);
    }
    order.push_back(to);
  }
  if (!order.empty()) lines.offsets.push_back(order.size());
  reorder(order, lines, attributes);
  for (const auto& [name, values] : edges) {
    std::vector<double>& column = attributes[name];
    column.clear();
    for (const double value : values) column.insert(column.end(), 2, value);
  }
}

/// Joins consecutive vertices of equal `line`.
void join_by_number(const std::vector<double>& line, LineSet& lines) {
  for (std::size_t i = 1; i < line.size(); ++i)
    if (line[i] != line[i - 1]) lines.offsets.push_back(i);
  lines.offsets.push_back(line.size());
}

LineSet read_ply_lines(const std::filesystem::path& path) {
  LineSet lines;
  std::optional<VertexAttributes> edges;
  VertexAttributes attributes =
      read_elements(path, lines, [&](const ply::Element& element, ply::Reader& reader) {
        if (element.name != "edge") return false;
        edges = read_columns(reader, element);
        return true;
      });
  const auto line = attributes.extract("line");
  if (line)
    join_by_number(line.mapped(), lines);
  else if (edges)
    join_by_edges(std::move(*edges), path.string(), lines, attributes);
  else
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
  return {.ending = ".ply",
          .title = "Stanford polygon file, text or binary",
          .traps =
              "lines by edges or by the property line; Gaussian splats are balls of their peak "
              "opacity, their size the scalar radius",
          .read_mesh = read_ply,
          .read_lines = read_ply_lines,
          .read_points = read_ply_points,
          .write_mesh = write_ply,
          .write_lines = write_ply_lines,
          .write_points = write_ply_points};
}

}  // namespace pellucid::geometry
