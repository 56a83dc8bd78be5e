// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "core/vec.h"

namespace pellucid::geometry {

/// A GltfCamera stands at `eye` and looks along `forward`, both in the document's world, which
/// places its meshes. It has either an angle or a height of view.
struct GltfCamera {
  Vec3 eye, forward, up;              // directions are unit
  std::optional<double> fov_degrees;  // vertical, of a perspective camera
  std::optional<double> height;       // world units, of an orthographic one
};

/// Reads the cameras of a .gltf or .glb file's scene, in the order of its nodes. Throws InputError
/// for what is not as the format has it, and for a node whose transform has no such directions.
std::vector<GltfCamera> read_gltf_cameras(const std::filesystem::path& path);

}  // namespace pellucid::geometry
