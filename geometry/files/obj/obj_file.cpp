// SPDX-License-Identifier: GPL-3.0-or-later
// Wavefront OBJ as triangles and lines, and back.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>

#include "core/files/output_file.h"
#include "geometry/files/face_colors.h"
#include "geometry/files/mesh_formats.h"
#include "geometry/files/obj/obj_document.h"
#include "geometry/files/obj/obj_materials.h"
#include "geometry/polygons/triangulate.h"

namespace pellucid::geometry {
namespace {

/// Gives every pair of a position and a normal that a face has a vertex of its own. The first of a
/// position keeps its number; a corner without a normal has (0, 0, 0), which is none.
class VertexPairs {
 public:
  VertexPairs(const ObjDocument& document, TriangleMesh& mesh)
      : document_(document), mesh_(mesh), first_(document.positions.size()) {
    mesh.positions = document.positions;
    mesh.colors = document.colors;
    mesh.normals.assign(document.positions.size(), Vec3(0));
  }

  std::uint32_t vertex(const ObjCorner& corner) {
    const Vec3 normal = corner.normal == obj_none ? Vec3(0) : document_.normals[corner.normal];
    std::optional<Vec3>& first = first_[corner.position];
    if (!first) {
      first = normal;
      mesh_.normals[corner.position] = normal;
    }
    if (same(*first, normal)) return corner.position;
    const auto [found, is_new] = further_.try_emplace(
        {corner.position, bits(normal.x), bits(normal.y), bits(normal.z)}, size());
    if (is_new) copy(corner.position, normal);
    return found->second;
  }

 private:
  static std::uint64_t bits(double x) { return std::bit_cast<std::uint64_t>(x); }
  static bool same(const Vec3& a, const Vec3& b) {
    return bits(a.x) == bits(b.x) && bits(a.y) == bits(b.y) && bits(a.z) == bits(b.z);
  }
  std::uint32_t size() const { return std::uint32_t(mesh_.positions.size()); }
  void copy(std::uint32_t position, const Vec3& normal) {
    mesh_.positions.push_back(document_.positions[position]);
    mesh_.normals.push_back(normal);
    if (!mesh_.colors.empty()) mesh_.colors.push_back(document_.colors[position]);
  }

  const ObjDocument& document_;
  TriangleMesh& mesh_;
  std::vector<std::optional<Vec3>> first_;                         // normal, by position
  std::map<std::array<std::uint64_t, 4>, std::uint32_t> further_;  // by position and normal's bits
};

/// Adds the triangles of all faces; returns of each the number of its face.
std::vector<std::size_t> add_triangles(const ObjDocument& document, TriangleMesh& mesh) {
  VertexPairs pairs(document, mesh);
  std::vector<std::size_t> faces;
  std::vector<std::uint32_t> polygon;
  for (std::size_t face = 0; face < document.faces.corners.count(); ++face) {
    polygon.clear();
    for (const ObjCorner& corner : document.faces.corners.row(face))
      polygon.push_back(pairs.vertex(corner));
    triangulate_polygon(mesh.positions, polygon, mesh.triangles);
    faces.resize(mesh.triangles.size(), face);
  }
  if (document.normals.empty()) mesh.normals.clear();
  return faces;
}

FileMesh read_obj(const std::filesystem::path& path) {
  const ObjDocument document = read_obj_document(path);
  FileMesh mesh;
  mesh.remarks = document.remarks;
  const std::vector<std::size_t> faces = add_triangles(document, mesh);
  const std::vector<Rgba> of_faces = obj_element_colors(document, document.faces, mesh.remarks);
  if (of_faces.empty()) return mesh;
  FaceColors of_triangles;
  for (const std::size_t face : faces) of_triangles.colors.push_back(of_faces[face]);
  color_faces(of_triangles, mesh);
  return mesh;
}

std::string texture_name(std::size_t k) { return fmt::format("attribute{}", k); }

/// Numbers of the points of lines: those of the "vt" that a corner names, else of the one that is
/// listed as its position is, when there are as many. (So do the data sets of M. Kern et al., A
/// Comparison of Rendering Techniques for 3D Line Sets with Transparency, 2020.) They are called
/// attribute0, attribute1, … as those of .binlines; a point that has none has NaN.
VertexAttributes texture_attributes(const ObjDocument& document) {
  VertexAttributes attributes;
  const Rows<double>& textures = document.textures;
  const bool by_position = textures.count() == document.positions.size();
  std::size_t count = 0;
  for (std::size_t i = 0; i < textures.count(); ++i)
    count = std::max(count, textures.row(i).size());
  for (std::size_t k = 0; k < count; ++k)
    for (const ObjCorner& corner : document.lines.corners.values) {
      const std::uint32_t i =
          corner.texture == obj_none && by_position ? corner.position : corner.texture;
      const bool has = i < textures.count() && k < textures.row(i).size();
      attributes[texture_name(k)].push_back(has ? textures.row(i)[k] : NAN);
    }
  return attributes;
}

FileLines read_obj_lines(const std::filesystem::path& path) {
  const ObjDocument document = read_obj_document(path);
  const Rows<ObjCorner>& corners = document.lines.corners;
  FileLines lines;
  lines.remarks = document.remarks;
  for (const ObjCorner& corner : corners.values) {
    lines.positions.push_back(document.positions[corner.position]);
    if (!document.colors.empty()) lines.colors.push_back(document.colors[corner.position]);
  }
  lines.offsets.assign(corners.ends.begin(), corners.ends.end());
  lines.scalars = texture_attributes(document);
  for (std::size_t i = 0; i < document.textures.count(); ++i)
    for (std::size_t k = 0; k < document.textures.row(i).size(); ++k)
      lines.values[texture_name(k)].push_back(document.textures.row(i)[k]);
  const std::vector<Rgba> of_lines = obj_element_colors(document, document.lines, lines.remarks);
  for (std::size_t line = 0; line < of_lines.size(); ++line)
    lines.colors.resize(corners.ends[line + 1], of_lines[line]);
  return lines;
}

std::string encode_obj(const TriangleMesh& mesh, const std::string& origin) {
  std::string out = fmt::format("# {}\n", origin);
  const auto to = std::back_inserter(out);
  for (const Vec3& x : mesh.positions) fmt::format_to(to, "v {} {} {}\n", x.x, x.y, x.z);
  for (const Vec3& n : mesh.normals) fmt::format_to(to, "vn {} {} {}\n", n.x, n.y, n.z);
  const bool lit = !mesh.normals.empty();
  for (const auto& [a, b, c] : mesh.triangles)
    if (lit)
      fmt::format_to(to, "f {0}//{0} {1}//{1} {2}//{2}\n", a + 1, b + 1, c + 1);
    else
      fmt::format_to(to, "f {} {} {}\n", a + 1, b + 1, c + 1);
  return out;
}

std::string encode_obj(const LineSet& lines, const std::string& origin) {
  std::string out = fmt::format("# {}\n", origin);
  const auto to = std::back_inserter(out);
  for (const Vec3& x : lines.positions) fmt::format_to(to, "v {} {} {}\n", x.x, x.y, x.z);
  for (std::size_t line = 0; line < lines.line_count(); ++line) {
    out += 'l';
    for (std::uint64_t i = lines.offsets[line]; i < lines.offsets[line + 1]; ++i)
      fmt::format_to(to, " {}", i + 1);
    out += '\n';
  }
  return out;
}

void write_obj(const std::filesystem::path& path, const TriangleMesh& mesh,
               const std::string& origin) {
  write_text(path, encode_obj(mesh, origin));
}
void write_obj_lines(const std::filesystem::path& path, const LineSet& lines,
                     const std::string& origin) {
  write_text(path, encode_obj(lines, origin));
}

}  // namespace

FormatRow obj_format() {
  return {
      .ending = ".obj",
      .title = "Wavefront object",
      .traps =
          "faces and lines have Kd and d (else 1 - Tr) of their materials where vertices have no "
          "colours; no textures; vt at lines are the scalars attribute0, …; written are positions, "
          "normals, triangles and lines, no scalars and no colours",
      .read_mesh = read_obj,
      .read_lines = read_obj_lines,
      .write_mesh = write_obj,
      .write_lines = write_obj_lines,
      .writes_scalars = false};
}

}  // namespace pellucid::geometry
