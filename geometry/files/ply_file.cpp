// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/error.h"
#include "core/files/output_file.h"
#include "geometry/default_color.h"
#include "geometry/files/color_names.h"
#include "geometry/files/face_colors.h"
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

/// The length of a list, which a file may write as any number type. The reader throws long before
/// a length that no file holds.
std::uint64_t list_length(ply::Reader& reader, const ply::Property& property) {
  constexpr double most = 1e18;
  const double length = reader.next(property.count_type);
  if (!(length >= 0 && length < most) || length != std::floor(length))
    throw InputError(
        fmt::format("{}: '{}': a list of {} values; accepted: a whole number from 0 on",
                    reader.where(), property.name, length));
  return std::uint64_t(length);
}

void skip(ply::Reader& reader, const ply::Property& property) {
  const std::uint64_t count = property.is_list ? list_length(reader, property) : 1;
  for (std::uint64_t i = 0; i < count; ++i) reader.next(property.type);
}

void skip(ply::Reader& reader, const ply::Element& element) {
  for (std::uint64_t i = 0; i < element.count; ++i)
    for (const ply::Property& property : element.properties) skip(reader, property);
}

/// Columns are the numbers of an element's records by name, colours by their channels; lists are
/// none of them.
class Columns {
 public:
  explicit Columns(const ply::Element& element) {
    std::vector<std::string> names;
    for (const ply::Property& property : element.properties)
      if (!property.is_list) names.push_back(property.name);
    const auto channels = color_channels(names);
    for (const ply::Property& property : element.properties) {
      const auto channel = channels.find(property.name);
      const bool is_color = channel != channels.end();
      columns_.push_back(
          {property.is_list ? nullptr : &values_[is_color ? channel->second : property.name],
           is_color ? color_scale(property.type) : 1});
      if (columns_.back().values) columns_.back().values->reserve(element.count);
    }
  }

  /// Reads the value of a property, by its number, which is no list.
  void read(ply::Reader& reader, const ply::Property& property, std::size_t number) {
    columns_[number].values->push_back(reader.next(property.type) / columns_[number].scale);
  }
  VertexAttributes take() { return std::move(values_); }

 private:
  struct Column {
    std::vector<double>* values = nullptr;  // none: of a list
    double scale = 1;
  };
  VertexAttributes values_;
  std::vector<Column> columns_;
};

VertexAttributes read_columns(ply::Reader& reader, const ply::Element& element) {
  Columns columns(element);
  for (std::uint64_t i = 0; i < element.count; ++i)
    for (std::size_t k = 0; k < element.properties.size(); ++k) {
      const ply::Property& property = element.properties[k];
      if (property.is_list)
        skip(reader, property);
      else
        columns.read(reader, property, k);
    }
  return columns.take();
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

constexpr std::uint64_t no_face = ~std::uint64_t(0);

/// Numbers of faces by name, and each triangle's face: no_face of those in strips.
struct FaceNumbers {
  VertexAttributes values;
  std::vector<std::uint64_t> faces;
};

FaceNumbers read_faces(ply::Reader& reader, const ply::Element& element, TriangleMesh& mesh) {
  FaceNumbers numbers;
  numbers.faces.assign(mesh.triangles.size(), no_face);
  Columns columns(element);
  mesh.triangles.reserve(element.count);
  for (std::uint64_t i = 0; i < element.count; ++i) {
    for (std::size_t k = 0; k < element.properties.size(); ++k) {
      const ply::Property& property = element.properties[k];
      if (!property.is_list)
        columns.read(reader, property, k);
      else if (is_corners(property))
        read_polygon(reader, property, i, mesh);
      else
        skip(reader, property);
    }
    numbers.faces.resize(mesh.triangles.size(), i);
  }
  numbers.values = columns.take();
  return numbers;
}

/// Colours are those of faces where the vertices have none; all other numbers are scalars.
void take_face_numbers(FaceNumbers numbers, TriangleMesh& mesh) {
  numbers.faces.resize(mesh.triangles.size(), no_face);
  VertexAttributes of_triangles;
  for (const auto& [name, values] : numbers.values) {
    std::vector<double>& column = of_triangles[name];
    column.reserve(mesh.triangles.size());
    for (const std::uint64_t face : numbers.faces)
      column.push_back(face == no_face ? NAN : values[face]);
  }
  if (mesh.colors.empty())
    if (auto colors = take_colors(of_triangles, mesh.triangles.size()); !colors.empty()) {
      for (std::size_t i = 0; i < colors.size(); ++i)
        if (numbers.faces[i] == no_face) colors[i] = Rgba(default_color, 1);
      color_faces(colors, mesh);
    }
  mesh.face_scalars = std::move(of_triangles);
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

[[noreturn]] void refuse_order(const ply::Element& element, const ply::Reader& reader) {
  throw InputError(fmt::format("{}: the element '{}' stands before 'vertex'; accepted: behind it",
                               reader.where(), element.name));
}

TriangleMesh read_ply(const std::filesystem::path& path) {
  TriangleMesh mesh;
  FaceNumbers numbers;
  auto attributes =
      read_elements(path, mesh, [&](const ply::Element& element, ply::Reader& reader) {
        if (element.name != "face" && element.name != "tristrips") return false;
        if (element.count > 0 && mesh.positions.empty()) refuse_order(element, reader);
        if (element.name == "face")
          numbers = read_faces(reader, element, mesh);
        else
          read_strips(reader, element, mesh);
        return true;
      });
  take_attributes(std::move(attributes), mesh);
  take_face_numbers(std::move(numbers), mesh);
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
