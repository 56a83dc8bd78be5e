// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <vector>

#include "core/vec.h"
#include "geometry/files/gltf/gltf_document.h"

namespace pellucid::geometry {

/// So many nodes may stand above one: they are gone through one within another.
constexpr int deepest_gltf_node = 1000;

/// Returns a node's transform: from the node's coordinates to its parent's.
Mat4 gltf_transform(const GltfDocument& document, const nlohmann::json& node);

/// A GltfInstances says where a node's mesh stands: from each instance's coordinates to the node's.
struct GltfInstances {
  std::vector<Mat4> node_from_instance;
  std::set<std::string> unread;  // further attributes of the instances
};

/// Returns the instances of EXT_mesh_gpu_instancing; one, as the mesh is, of a node without the
/// extension. Throws InputError for instances whose attributes differ in number, or hold no bytes
/// of the file.
GltfInstances gltf_instances(GltfDocument& document, const nlohmann::json& node);

}  // namespace pellucid::geometry
