// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "geometry/vertices.h"

namespace pellucid::geometry {

/// A GltfMode says how a primitive joins its vertices, by the format's numbers.
enum class GltfMode {
  points = 0,
  lines = 1,
  line_loop = 2,
  line_strip = 3,
  triangles = 4,
  strip = 5,
  fan = 6
};

/// A GltfScene holds what all primitives of some modes have become in the world, one behind
/// another; triangles and polylines hold indices of vertices.
struct GltfScene {
  Vertices vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::vector<std::uint32_t>> polylines;
};

/// Reads the primitives of the modes `first` to `last` of a .gltf or .glb file: of its scene's
/// nodes, each where its transforms and instances put it; of a file without scenes of all meshes.
/// Throws InputError for what is not as the format has it, and for skins.
GltfScene read_gltf_scene(const std::filesystem::path& path, GltfMode first, GltfMode last);

}  // namespace pellucid::geometry
