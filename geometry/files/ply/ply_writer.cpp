// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/files/ply/ply_writer.h"

#include <fmt/format.h>

#include <bit>
#include <cstring>

#include "core/files/output_file.h"
#include "geometry/files/scalar_names.h"

namespace pellucid::geometry {
namespace {

static_assert(std::endian::native == std::endian::little, "encode_ply writes in memory order");

template <class T>
void append(std::string& out, T value) {
  char bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  out.append(bytes, sizeof value);
}

std::string encode_ply(const TriangleMesh& mesh, const std::string& origin) {
  std::string out = fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment {}\nelement vertex {}\nproperty double "
      "x\nproperty double "
      "y\nproperty double z\n",
      origin, mesh.positions.size());
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

/// Other programs draw lines by their edges.
void append_edges(std::string& out, const LineSet& lines) {
  for (std::size_t line = 0; line < lines.line_count(); ++line)
    for (std::uint64_t i = lines.offsets[line] + 1; i < lines.offsets[line + 1]; ++i) {
      append(out, static_cast<std::uint32_t>(i - 1));
      append(out, static_cast<std::uint32_t>(i));
    }
}

std::string encode_ply(const LineSet& lines, const std::string& origin) {
  std::string out = fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment {}\n"
      "comment consecutive vertices of one line are joined\n"
      "element vertex {}\nproperty double x\nproperty double y\nproperty double z\n"
      "property uint line\n",
      origin, lines.positions.size());
  if (!lines.colors.empty())
    out += "property float red\nproperty float green\nproperty float blue\nproperty float alpha\n";
  if (!lines.importance.empty()) out += "property float importance\n";
  for (const auto& [name, values] : lines.scalars) out += fmt::format("property double {}\n", name);
  out += fmt::format("element edge {}\nproperty uint vertex1\nproperty uint vertex2\nend_header\n",
                     lines.segment_count());
  for (std::size_t line = 0; line < lines.line_count(); ++line)
    for (std::uint64_t i = lines.offsets[line]; i < lines.offsets[line + 1]; ++i) {
      for (int k = 0; k < 3; ++k) append(out, lines.positions[i][k]);
      append(out, static_cast<std::uint32_t>(line));
      for (int k = 0; k < 4 && !lines.colors.empty(); ++k) append(out, lines.colors[i][k]);
      if (!lines.importance.empty()) append(out, lines.importance[i]);
      for (const auto& [name, values] : lines.scalars) append(out, values[i]);
    }
  append_edges(out, lines);
  return out;
}

}  // namespace

void write_ply(const std::filesystem::path& path, const TriangleMesh& mesh,
               const std::string& origin) {
  check_ply_names(path, mesh);
  write_text(path, encode_ply(mesh, origin));
}
void write_ply_lines(const std::filesystem::path& path, const LineSet& lines,
                     const std::string& origin) {
  check_ply_names(path, lines, "line");
  write_text(path, encode_ply(lines, origin));
}
void write_ply_points(const std::filesystem::path& path, const PointSet& points,
                      const std::string& origin) {
  write_ply(path, {Vertices(points), {}, {}}, origin);
}

}  // namespace pellucid::geometry
