// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "core/vec.h"
#include "geometry/files/gltf/gltf_document.h"

namespace pellucid::geometry {

/// A GltfVisit is told a node, its number, and its transform: from its coordinates to the world's.
using GltfVisit = std::function<void(const nlohmann::json& node, const nlohmann::json& index,
                                     const Mat4& world_from_node)>;

/// Visits the nodes of the document's scene, if it has one, parents before their children. Throws
/// InputError for a node with two parents, or with more than 1000 above it: they are gone through
/// one within another.
void visit_gltf_nodes(const GltfDocument& document, const GltfVisit& visit);

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
