// SPDX-License-Identifier: GPL-3.0-or-later
// Of each primitive POSITION, NORMAL, COLOR_0 times the material's factor, and attributes of one
// number of one's own, "_SPEED", which become scalars, "speed". Colours are taken as the file has
// them: glTF calls them linear, a scene's are display values. Morph targets have the weights that
// the document gives them. Textures and animations are left out, skins are refused.

#include "geometry/files/gltf/gltf_scene.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <glm/matrix.hpp>
#include <limits>
#include <set>
#include <span>

#include "core/error.h"
#include "core/options/lower_case.h"
#include "geometry/files/gltf/gltf_document.h"
#include "geometry/files/gltf/gltf_extensions.h"
#include "geometry/files/gltf/gltf_materials.h"
#include "geometry/files/gltf/gltf_transforms.h"
#include "geometry/files/mesh_formats.h"

namespace pellucid::geometry {
namespace {

using Json = nlohmann::json;

class GltfReader {
 public:
  /// Takes the primitives of these modes.
  GltfReader(const std::filesystem::path& path, GltfMode first_mode, GltfMode last_mode)
      : document_(path), first_mode_(first_mode), last_mode_(last_mode) {}

  /// What is of another type than the format has it, such as a text for a list, is refused where it
  /// is used.
  GltfScene read() {
    try {
      return read_scene();
    } catch (const Json::exception& error) {
      document_.fail(fmt::format("not as glTF has it: {}", error.what()));
    }
  }

 private:
  GltfScene read_scene() {
    const Json& root = document_.root();
    if (root.contains("scenes")) {
      visit_gltf_nodes(document_, [&](const Json& node, const Json& index, const Mat4& world) {
        read_node(node, index, world);
      });
    } else {  // a library of meshes
      for (std::size_t i = 0; i < root.value("meshes", Json::array()).size(); ++i)
        read_mesh(Json(i), Json::object(), Mat4(1));
    }
    finish_attributes();
    add_remarks();
    return std::move(scene_);
  }

  void read_node(const Json& node, const Json& index, const Mat4& world_from_node) {
    if (!node.contains("mesh")) return;
    if (node.contains("skin"))
      document_.fail(
          fmt::format("nodes[{}] has a skin, which is not read; accepted: meshes as they stand, "
                      "with the pose applied",
                      index.dump()));
    read_instances(node, world_from_node);
  }

  void read_instances(const Json& node, const Mat4& world_from_node) {
    GltfInstances instances = gltf_instances(document_, node);
    unread_.merge(instances.unread);
    for (const Mat4& node_from_instance : instances.node_from_instance)
      read_mesh(node["mesh"], node, world_from_node * node_from_instance);
  }

  void read_mesh(const Json& index, const Json& node, const Mat4& world) {
    const Json& mesh = document_.element("meshes", index);
    weights_ = node.value("weights", mesh.value("weights", Json::array()));
    const auto primitives = mesh.find("primitives");
    if (primitives == mesh.end()) return;
    for (const Json& primitive : *primitives) {
      const Json mode =
          primitive.is_object() ? primitive.value("mode", Json(int(GltfMode::triangles))) : Json();
      if (!mode.is_number_integer() || mode < 0 || mode > 6)
        document_.fail(fmt::format("a primitive's mode {}; accepted: 0 … 6", mode.dump()));
      const auto joined = GltfMode(mode.get<int>());
      if (joined >= first_mode_ && joined <= last_mode_) read_primitive(primitive, joined, world);
    }
  }

  void read_primitive(const Json& primitive, GltfMode mode, const Mat4& world) {
    const Json attributes = primitive.value("attributes", Json::object());
    if (!attributes.is_object() || !attributes.contains("POSITION")) return;
    Vertices& all = scene_.vertices;
    const std::size_t first = all.positions.size();
    const AccessorData positions = morphed("POSITION", primitive, 3, 3);
    constexpr std::size_t most = std::numeric_limits<std::uint32_t>::max();  // by their indices
    if (positions.count > most - first)
      document_.fail(fmt::format("more than {} vertices, those of all nodes", most));
    for (std::size_t i = 0; i < positions.count; ++i)
      all.positions.emplace_back(
          world * glm::dvec4(positions.at(i, 0), positions.at(i, 1), positions.at(i, 2), 1));
    add_normals(primitive, positions.count, world);
    add_colors(primitive, positions.count);
    for (const auto& [name, accessor] : attributes.items())
      if (name.starts_with('_')) add_scalar(name, accessor, first, positions.count);
    join(mode, indices(primitive, positions.count), std::uint32_t(first));
  }

  AccessorData vectors(const Json& index, int least, int most) {
    AccessorData data = document_.accessor(index);
    if (data.components < least || data.components > most)
      document_.fail(
          fmt::format("accessors[{}]: {} components a vertex", index.dump(), data.components));
    return data;
  }

  /// The vertices' numbers, and those that the targets add, each times its weight.
  AccessorData morphed(const char* name, const Json& primitive, int least, int most) {
    AccessorData data = vectors(primitive["attributes"][name], least, most);
    const Json targets = primitive.value("targets", Json::array());
    if (!weights_.empty() && weights_.size() != targets.size())
      document_.fail(
          fmt::format("{} weights of {} morph targets", weights_.size(), targets.size()));
    for (std::size_t t = 0; t < weights_.size(); ++t) {
      const double weight = weights_[t];
      if (weight == 0 || !targets[t].contains(name)) continue;
      const AccessorData more = vectors(targets[t][name], data.components, data.components);
      check_count(more, data.count, fmt::format("a morph target's {}", name));
      for (std::size_t i = 0; i < data.numbers.size(); ++i)
        data.numbers[i] += weight * more.numbers[i];
    }
    return data;
  }

  void check_count(const AccessorData& data, std::size_t count, const std::string& name) const {
    if (data.count != count)
      document_.fail(fmt::format("{} has {} values for {} vertices", name, data.count, count));
  }

  /// Of vertices without a normal it is (0, 0, 0), which is none.
  void add_normals(const Json& primitive, std::size_t count, const Mat4& world) {
    std::vector<Vec3>& normals = scene_.vertices.normals;
    const std::size_t first = normals.size();
    normals.resize(first + count, Vec3(0));
    if (!primitive["attributes"].contains("NORMAL")) return;
    has_normals_ = true;
    const AccessorData data = morphed("NORMAL", primitive, 3, 3);
    check_count(data, count, "NORMAL");
    const Mat3 of_normals = glm::transpose(glm::inverse(Mat3(world)));
    for (std::size_t i = 0; i < count; ++i)
      normals[first + i] = of_normals * Vec3(data.at(i, 0), data.at(i, 1), data.at(i, 2));
  }

  void add_colors(const Json& primitive, std::size_t count) {
    const GltfMaterial material = gltf_material(document_, primitive);
    if (material.is_textured) textured_.insert(primitive["material"].get<std::size_t>());
    AccessorData data;
    if (primitive["attributes"].contains("COLOR_0")) {
      data = morphed("COLOR_0", primitive, 3, 4);
      if (!weights_.empty())
        for (double& channel : data.numbers) channel = std::clamp(channel, 0.0, 1.0);
      check_count(data, count, "COLOR_0");
    }
    has_colors_ = has_colors_ || data.count > 0 || material.is_given;
    for (std::size_t i = 0; i < count; ++i) {
      glm::dvec4 color = material.factor;
      for (int c = 0; c < data.components && data.count > 0; ++c) color[c] *= data.at(i, c);
      if (material.alpha == GltfMaterial::Alpha::opaque) color.a = 1;
      scene_.vertices.colors.emplace_back(color);
    }
    if (material.alpha == GltfMaterial::Alpha::mask) mask(material.cutoff, count);
  }

  /// Makes the alpha of the last `count` vertices 0 or 1. Where it lies on both sides of the cutoff
  /// the edge would run across triangles, which vertices cannot have.
  void mask(double cutoff, std::size_t count) {
    auto& colors = scene_.vertices.colors;
    const std::span<Rgba> some(colors.data() + colors.size() - count, count);
    const auto shown =
        std::ranges::count_if(some, [&](const Rgba& c) { return c.a >= float(cutoff); });
    if (shown != 0 && shown != std::ptrdiff_t(count))
      document_.fail(
          fmt::format("alphaMode MASK: the alpha of {} of {} vertices is below the cutoff of {}; "
                      "accepted: all or none of a primitive",
                      std::ptrdiff_t(count) - shown, count, cutoff));
    for (Rgba& color : some) color.a = shown > 0 ? 1.f : 0.f;
  }

  /// A scalar that other primitives do not have is NaN at their vertices.
  void add_scalar(const std::string& name, const Json& index, std::size_t first,
                  std::size_t count) {
    const AccessorData data = document_.accessor(index);
    if (data.components != 1) return;
    check_count(data, count, name);
    std::vector<double>& column = attributes_[lower_case(name.substr(1))];
    column.resize(first, NAN);
    column.insert(column.end(), data.numbers.begin(), data.numbers.end());
  }

  std::vector<std::uint32_t> indices(const Json& primitive, std::size_t count) {
    std::vector<std::uint32_t> result;
    if (!primitive.contains("indices")) {
      for (std::size_t i = 0; i < count; ++i) result.push_back(std::uint32_t(i));
      return result;
    }
    const AccessorData data = vectors(primitive["indices"], 1, 1);
    for (const double index : data.numbers) {
      if (!(index >= 0 && index < double(count)) || index != std::floor(index))
        document_.fail(fmt::format("index {} of a primitive of {} vertices", index, count));
      result.push_back(std::uint32_t(index));
    }
    return result;
  }

  void join(GltfMode mode, std::vector<std::uint32_t> corners, std::uint32_t first) {
    for (std::uint32_t& corner : corners) corner += first;
    const std::size_t n = corners.size();
    using enum GltfMode;
    auto& all = scene_.triangles;
    auto& polylines = scene_.polylines;
    if (mode == triangles)
      for (std::size_t i = 0; i + 2 < n; i += 3)
        all.push_back({corners[i], corners[i + 1], corners[i + 2]});
    if (mode == strip)
      for (std::size_t i = 0; i + 2 < n; ++i)
        all.push_back({corners[i], corners[i + 1 + i % 2], corners[i + 2 - i % 2]});
    if (mode == fan)
      for (std::size_t i = 1; i + 1 < n; ++i)
        all.push_back({corners[i], corners[i + 1], corners[0]});
    if (mode == lines)
      for (std::size_t i = 0; i + 1 < n; i += 2) polylines.push_back({corners[i], corners[i + 1]});
    if (mode == line_loop && n > 0) corners.push_back(corners.front());
    if (mode == line_loop || mode == line_strip) polylines.push_back(std::move(corners));
  }

  void finish_attributes() {
    Vertices& vertices = scene_.vertices;
    if (!has_normals_) vertices.normals.clear();
    if (!has_colors_) vertices.colors.clear();
    for (auto& [name, column] : attributes_) {
      column.resize(vertices.positions.size(), NAN);
      if (name == "importance")
        vertices.importance.assign(column.begin(), column.end());
      else
        vertices.scalars[name] = std::move(column);
    }
  }

  /// What of the document is not drawn.
  void add_remarks() {
    std::vector<std::string>& remarks = scene_.vertices.remarks;
    for (const Json& name : document_.root().value("extensionsUsed", Json::array()))
      if (const std::string remark = gltf_extension_remark(name.get<std::string>());
          !remark.empty())
        remarks.push_back(remark);
    if (!textured_.empty())
      remarks.push_back(
          fmt::format("textures are not read: materials[{}]", fmt::join(textured_, "], [")));
    if (!unread_.empty())
      remarks.push_back(
          fmt::format("attributes of instances are not read: {}", fmt::join(unread_, ", ")));
  }

  GltfDocument document_;
  GltfMode first_mode_, last_mode_;
  Json weights_;                    // of the mesh's morph targets; none: of all 0
  std::set<std::size_t> textured_;  // materials with a texture of their colour
  std::set<std::string> unread_;    // attributes of instances
  bool has_normals_ = false, has_colors_ = false;
  VertexAttributes attributes_;
  GltfScene scene_;
};

}  // namespace

GltfScene read_gltf_scene(const std::filesystem::path& path, GltfMode first, GltfMode last) {
  return GltfReader(path, first, last).read();
}

}  // namespace pellucid::geometry
