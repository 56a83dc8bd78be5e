// SPDX-License-Identifier: GPL-3.0-or-later
// .gltf and .glb as triangles, lines and points of the world.

#include "geometry/files/gltf/gltf_scene.h"
#include "geometry/files/mesh_formats.h"

namespace pellucid::geometry {
namespace {

FileMesh read_gltf(const std::filesystem::path& path) {
  GltfScene all = read_gltf_scene(path, GltfMode::triangles, GltfMode::fan);
  FileMesh mesh;
  static_cast<Vertices&>(mesh) = std::move(all.vertices);
  mesh.triangles = std::move(all.triangles);
  return mesh;
}

FileLines read_gltf_lines(const std::filesystem::path& path) {
  const GltfScene all = read_gltf_scene(path, GltfMode::lines, GltfMode::line_strip);
  const auto pick = [&](const auto& from, auto& to) {
    if (from.empty()) return;
    for (const auto& polyline : all.polylines)
      for (const std::uint32_t i : polyline) to.push_back(from[i]);
  };
  FileLines set;
  set.remarks = all.vertices.remarks;
  pick(all.vertices.positions, set.positions);
  pick(all.vertices.colors, set.colors);
  pick(all.vertices.importance, set.importance);
  for (const auto& [name, column] : all.vertices.scalars) pick(column, set.scalars[name]);
  set.values = all.vertices.scalars;
  for (const auto& polyline : all.polylines)
    set.offsets.push_back(set.offsets.back() + polyline.size());
  return set;
}

/// Those that are points; in a file without any the vertices of all that there is.
PointSet read_gltf_points(const std::filesystem::path& path) {
  GltfScene all = read_gltf_scene(path, GltfMode::points, GltfMode::points);
  if (all.vertices.positions.empty()) all = read_gltf_scene(path, GltfMode::lines, GltfMode::fan);
  PointSet set;
  static_cast<Vertices&>(set) = std::move(all.vertices);
  return set;
}

FormatRow row(std::string_view ending, std::string_view title) {
  return {
      .ending = ending,
      .title = title,
      .traps =
          "alpha counts where the material's alphaMode is BLEND, and is 0 or 1 at MASK; attributes "
          "_NAME of one number are scalars; colours are taken for display values; morph targets by "
          "their weights; instances; no textures, no compression; skins are refused",
      .read_mesh = read_gltf,
      .read_lines = read_gltf_lines,
      .read_points = read_gltf_points};
}

}  // namespace

FormatRow gltf_format() { return row(".gltf", "glTF 2.0"); }
FormatRow glb_format() { return row(".glb", "glTF 2.0, binary"); }

}  // namespace pellucid::geometry
