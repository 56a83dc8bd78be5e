// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/scene.h"

namespace pellucid::compare {

/// An ExportedObject is one object of the scene as other renderers are given it: vertices in world
/// units, with their final colours, and what joins them.
struct ExportedObject {
  std::string_view kind;  // "triangles", "lines", "points"
  std::string_view profile =
      {};                    // of lines: "ribbon", "tube"; of points: "disc", "sphere"; else empty
  scene::Radii radius = {};  // of lines and points
  bool opaque = false;
  /// Colours are those of the fragments: the light is in them, or there is none.
  bool lit = true;
  geometry::Vertices vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles = {};
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges = {};  // of lines, along each
  std::vector<std::uint32_t> line = {};  // of lines: each vertex's, from 0

  /// Returns the number of its triangles, segments or points.
  std::size_t count() const;
};

/// Makes ready the object of that index. The light is put into the colours where it is the same
/// all over each triangle: an orthographic camera, corners of one normal, and no channel beyond 1.
/// Throws InputError for an isosurface that is no mesh.
ExportedObject exported_object(const scene::Scene& scene, std::size_t index);

/// Returns the largest distance by which rounding to floats moves a vertex, in world units.
double float_rounding(const ExportedObject& object);

/// Writes a binary PLY file: floats x y z, nx ny nz where there are normals, red green blue alpha,
/// importance where there is any, radius where radii differ; of lines each vertex's `line`, and the
/// element `edge`. Throws as write_text() does.
void write_exported_ply(const std::filesystem::path& path, const ExportedObject& object);

}  // namespace pellucid::compare
