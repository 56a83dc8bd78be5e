// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "core/error.h"
#include "core/files/output_file.h"
#include "geometry/files/mesh_formats.h"
#include "geometry/files/ply_format.h"

namespace pellucid::geometry {
namespace {

static_assert(std::endian::native == std::endian::little, "encode_ply writes in memory order");

bool is_color(std::string_view name) {
  return name == "red" || name == "green" || name == "blue" || name == "alpha";
}

/// 8- and 16-bit colours count in steps of 1/255 and 1/65535; anything else is used as it stands.
double color_scale(const ply::Property& property) {
  if (!is_color(property.name)) return 1;
  if (property.type == ply::Type::uint8) return 255;
  if (property.type == ply::Type::uint16) return 65535;
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

void read_vertices(ply::Reader& reader, const ply::Element& element, Vertices& vertices,
                   VertexAttributes& attributes) {
  std::vector<std::vector<double>*> columns;
  for (const ply::Property& property : element.properties) {
    columns.push_back(property.is_list ? nullptr : &attributes[property.name]);
    if (columns.back()) columns.back()->reserve(element.count);
  }
  for (std::uint64_t i = 0; i < element.count; ++i)
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const ply::Property& property = element.properties[k];
      if (columns[k])
        columns[k]->push_back(reader.next(property.type) / color_scale(property));
      else
        skip(reader, property);
    }
  for (const char* axis : {"x", "y", "z"})
    if (!attributes.contains(axis))
      throw InputError(
          fmt::format("{}: element 'vertex' has no property '{}'", reader.where(), axis));
  const auto x = attributes.extract("x"), y = attributes.extract("y"), z = attributes.extract("z");
  vertices.positions.resize(element.count);
  for (std::uint64_t i = 0; i < element.count; ++i)
    vertices.positions[i] = {x.mapped()[i], y.mapped()[i], z.mapped()[i]};
}

std::uint32_t read_index(ply::Reader& reader, ply::Type type, std::uint64_t face,
                         std::size_t vertex_count) {
  const double index = reader.next(type);
  if (!(index >= 0 && index < double(vertex_count)) || index != std::uint32_t(index))
    throw InputError(fmt::format("{}: face {}: vertex index {}, but the file has {} vertices",
                                 reader.where(), face, index, vertex_count));
  return static_cast<std::uint32_t>(index);
}

/// A polygon becomes a fan of triangles around its first vertex.
void read_polygon(ply::Reader& reader, const ply::Property& property, std::uint64_t face,
                  TriangleMesh& mesh) {
  const std::uint64_t corners = list_length(reader, property);
  std::uint32_t first = 0, previous = 0;
  for (std::uint64_t k = 0; k < corners; ++k) {
    const std::uint32_t index = read_index(reader, property.type, face, mesh.positions.size());
    if (k == 0) first = index;
    if (k >= 2) mesh.triangles.push_back({first, previous, index});
    previous = index;
  }
}

void read_faces(ply::Reader& reader, const ply::Element& element, TriangleMesh& mesh) {
  mesh.triangles.reserve(element.count);
  for (std::uint64_t i = 0; i < element.count; ++i)
    for (const ply::Property& property : element.properties) {
      const bool corners = property.is_list &&
                           (property.name == "vertex_indices" || property.name == "vertex_index");
      if (corners)
        read_polygon(reader, property, i, mesh);
      else
        skip(reader, property);
    }
}

/// Fills the vertices' positions, and the faces of `mesh` unless that is null.
VertexAttributes read_elements(const std::filesystem::path& path, Vertices& vertices,
                               TriangleMesh* mesh) {
  const std::string content = read_text(path);
  ply::Reader reader(path.string(), content);
  VertexAttributes attributes;
  for (const ply::Element& element : reader.read_header().elements) {
    check_count(reader, element);
    if (element.name == "vertex")
      read_vertices(reader, element, vertices, attributes);
    else if (element.name == "face" && mesh)
      read_faces(reader, element, *mesh);
    else
      skip(reader, element);
  }
  return attributes;
}

template <class T>
void append(std::string& out, T value) {
  char bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  out.append(bytes, sizeof value);
}

TriangleMesh read_ply(const std::filesystem::path& path) {
  TriangleMesh mesh;
  take_attributes(read_elements(path, mesh, &mesh), mesh);
  return mesh;
}

LineSet read_ply_lines(const std::filesystem::path& path) {
  LineSet lines;
  VertexAttributes attributes = read_elements(path, lines, nullptr);
  const std::size_t count = lines.positions.size();
  if (const auto line = attributes.extract("line"))
    for (std::size_t i = 1; i < count; ++i)
      if (line.mapped()[i] != line.mapped()[i - 1]) lines.offsets.push_back(i);
  lines.offsets.push_back(count);
  take_attributes(std::move(attributes), lines);
  return lines;
}

PointSet read_ply_points(const std::filesystem::path& path) {
  PointSet points;
  take_attributes(read_elements(path, points, nullptr), points);
  return points;
}

std::string encode_ply(const TriangleMesh& mesh) {
  std::string out = fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty double x\nproperty double "
      "y\nproperty double z\n",
      mesh.positions.size());
  if (!mesh.normals.empty()) out += "property double nx\nproperty double ny\nproperty double nz\n";
  if (!mesh.colors.empty())
    out += "property float red\nproperty float green\nproperty float blue\nproperty float alpha\n";
  if (!mesh.importance.empty()) out += "property float importance\n";
  for (const auto& [name, values] : mesh.scalars) out += fmt::format("property double {}\n", name);
  out += fmt::format("element face {}\nproperty list uchar uint vertex_indices\nend_header\n",
                     mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    for (int k = 0; k < 3; ++k) append(out, mesh.positions[i][k]);
    for (int k = 0; k < 3 && !mesh.normals.empty(); ++k) append(out, mesh.normals[i][k]);
    for (int k = 0; k < 4 && !mesh.colors.empty(); ++k) append(out, mesh.colors[i][k]);
    if (!mesh.importance.empty()) append(out, mesh.importance[i]);
    for (const auto& [name, values] : mesh.scalars) append(out, values[i]);
  }
  for (const auto& triangle : mesh.triangles) {
    append(out, std::uint8_t(3));
    for (const std::uint32_t index : triangle) append(out, index);
  }
  return out;
}

std::string encode_ply(const LineSet& lines) {
  std::string out = fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment consecutive vertices of one line are joined\n"
      "element vertex {}\nproperty double x\nproperty double y\nproperty double z\n"
      "property uint line\n",
      lines.positions.size());
  for (const auto& [name, values] : lines.scalars) out += fmt::format("property double {}\n", name);
  out += "end_header\n";
  for (std::size_t line = 0; line < lines.line_count(); ++line)
    for (std::uint64_t i = lines.offsets[line]; i < lines.offsets[line + 1]; ++i) {
      for (int k = 0; k < 3; ++k) append(out, lines.positions[i][k]);
      append(out, static_cast<std::uint32_t>(line));
      for (const auto& [name, values] : lines.scalars) append(out, values[i]);
    }
  return out;
}

void write_ply(const std::filesystem::path& path, const TriangleMesh& mesh) {
  write_text(path, encode_ply(mesh));
}
void write_ply_lines(const std::filesystem::path& path, const LineSet& lines) {
  write_text(path, encode_ply(lines));
}
void write_ply_points(const std::filesystem::path& path, const PointSet& points) {
  write_ply(path, {Vertices(points), {}});
}

}  // namespace

FormatRow ply_format() {
  return {.ending = ".ply",
          .title = "Stanford polygon file, text or binary",
          .read_mesh = read_ply,
          .read_lines = read_ply_lines,
          .read_points = read_ply_points,
          .write_mesh = write_ply,
          .write_lines = write_ply_lines,
          .write_points = write_ply_points};
}

}  // namespace pellucid::geometry
