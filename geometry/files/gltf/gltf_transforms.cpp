// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/files/gltf/gltf_transforms.h"

#include <fmt/format.h>

#include <glm/gtc/quaternion.hpp>
#include <optional>

namespace pellucid::geometry {
namespace {

using Json = nlohmann::json;

/// A quaternion x, y, z, w; no turn when it has no length.
Mat4 turned(double x, double y, double z, double w) {
  const glm::dquat turn(w, x, y, z);
  return glm::length(turn) > 0 ? glm::mat4_cast(glm::normalize(turn)) : Mat4(1);
}

/// One of TRANSLATION, ROTATION and SCALE, where there is one. Every tuple stands for a copy of the
/// mesh: those that no byte of the file answers for are refused.
std::optional<AccessorData> attribute(GltfDocument& document, const Json& attributes,
                                      const char* name, int components) {
  const auto found = attributes.find(name);
  if (found == attributes.end()) return std::nullopt;
  AccessorData data = document.accessor(*found);
  if (data.components != components ||
      !document.element("accessors", *found).contains("bufferView"))
    document.fail(fmt::format("EXT_mesh_gpu_instancing: {}: accepted: {} numbers of a buffer each",
                              name, components));
  return data;
}

/// Scaled, turned, and shifted.
Mat4 placed(const std::optional<AccessorData>& shifts, const std::optional<AccessorData>& turns,
            const std::optional<AccessorData>& scales, std::size_t i) {
  Mat4 m =
      turns ? turned(turns->at(i, 0), turns->at(i, 1), turns->at(i, 2), turns->at(i, 3)) : Mat4(1);
  for (int axis = 0; scales && axis < 3; ++axis) m[axis] *= scales->at(i, axis);
  if (shifts) m[3] = glm::dvec4(shifts->at(i, 0), shifts->at(i, 1), shifts->at(i, 2), 1);
  return m;
}

/// How many the attributes agree on.
std::size_t count_of(const GltfDocument& document,
                     std::initializer_list<const std::optional<AccessorData>*> attributes) {
  std::optional<std::size_t> count;
  for (const auto* attribute : attributes)
    if (*attribute) {
      if (count && *count != (*attribute)->count)
        document.fail(fmt::format("EXT_mesh_gpu_instancing: attributes of {} and of {} instances",
                                  *count, (*attribute)->count));
      count = (*attribute)->count;
    }
  if (!count)
    document.fail(
        "EXT_mesh_gpu_instancing: accepted: one of TRANSLATION, ROTATION, SCALE at least");
  return *count;
}

/// From the node's coordinates to its parent's.
Mat4 transform_of(const GltfDocument& document, const Json& node) {
  Mat4 m(1);
  if (const auto columns = document.numbers<16>(node, "matrix")) {
    for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = (*columns)[std::size_t(i)];
    return m;
  }
  if (const auto q = document.numbers<4>(node, "rotation"))
    m = turned((*q)[0], (*q)[1], (*q)[2], (*q)[3]);
  if (const auto scale = document.numbers<3>(node, "scale"))
    for (int axis = 0; axis < 3; ++axis) m[axis] *= (*scale)[std::size_t(axis)];
  if (const auto shift = document.numbers<3>(node, "translation"))
    m[3] = glm::dvec4((*shift)[0], (*shift)[1], (*shift)[2], 1);
  return m;
}

class NodeWalk {
 public:
  NodeWalk(const GltfDocument& document, const GltfVisit& visit)
      : document_(document), visit_(visit) {}

  void enter(const Json& index, const Mat4& world_from_parent, int depth) {
    constexpr int deepest = 1000;
    const Json& node = document_.element("nodes", index);
    if (!visited_.insert(index.get<std::size_t>()).second || depth > deepest)
      document_.fail(fmt::format("nodes[{}] has two parents, or more than {} levels above it",
                                 index.dump(), deepest));
    const Mat4 world_from_node = world_from_parent * transform_of(document_, node);
    visit_(node, index, world_from_node);
    if (const auto children = node.find("children"); children != node.end())
      for (const Json& child : *children) enter(child, world_from_node, depth + 1);
  }

 private:
  const GltfDocument& document_;
  const GltfVisit& visit_;
  std::set<std::size_t> visited_;  // each has one parent at most
};

}  // namespace

void visit_gltf_nodes(const GltfDocument& document, const GltfVisit& visit) {
  const Json& root = document.root();
  if (!root.contains("scenes")) return;
  const Json& scene = document.element("scenes", root.value("scene", Json(0)));
  NodeWalk walk(document, visit);
  for (const Json& node : scene.value("nodes", Json::array())) walk.enter(node, Mat4(1), 0);
}

GltfInstances gltf_instances(GltfDocument& document, const Json& node) {
  constexpr const char* name = "EXT_mesh_gpu_instancing";
  const auto extensions = node.find("extensions");
  if (extensions == node.end() || !extensions->contains(name)) return {{Mat4(1)}, {}};
  const Json attributes = (*extensions)[name].value("attributes", Json::object());
  const auto shifts = attribute(document, attributes, "TRANSLATION", 3);
  const auto turns = attribute(document, attributes, "ROTATION", 4);
  const auto scales = attribute(document, attributes, "SCALE", 3);
  GltfInstances instances;
  const std::size_t count = count_of(document, {&shifts, &turns, &scales});
  for (std::size_t i = 0; i < count; ++i)
    instances.node_from_instance.push_back(placed(shifts, turns, scales, i));
  for (const auto& [attribute, accessor] : attributes.items())
    if (attribute.starts_with('_')) instances.unread.insert(attribute);
  return instances;
}

}  // namespace pellucid::geometry
