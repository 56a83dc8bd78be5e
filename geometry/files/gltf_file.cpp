// SPDX-License-Identifier: GPL-3.0-or-later
// .gltf and .glb as triangles, lines and points of the world: the nodes of the document's scene
// with their transforms. Of each primitive POSITION, NORMAL, COLOR_0 times the material's base
// colour factor, and attributes of one number of one's own, "_SPEED", which become scalars,
// "speed". As the format says, alpha counts where the material's alphaMode is BLEND, is 0 or 1 at
// MASK, and 1 at OPAQUE, which is the default. Morph targets have the weights that the document
// gives them. Textures and animations are left out, skins are refused.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <optional>
#include <set>
#include <span>

#include "core/error.h"
#include "geometry/files/gltf_document.h"
#include "geometry/files/mesh_formats.h"

namespace pellucid::geometry {
namespace {

using Json = nlohmann::json;

enum Mode {
  points = 0,
  lines = 1,
  line_loop = 2,
  line_strip = 3,
  triangles = 4,
  strip = 5,
  fan = 6
};

/// What all primitives of a kind have become, one behind another.
struct Collected {
  Vertices vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::vector<std::uint32_t>> polylines;
};

/// Numbers of an array, when there are as many; all of them finite, since JSON has no others.
template <int N>
std::optional<std::array<double, N>> numbers_of(const Json& object, const char* key,
                                                const GltfDocument& document) {
  const auto found = object.find(key);
  if (found == object.end()) return std::nullopt;
  std::array<double, N> numbers{};
  bool fits = found->is_array() && found->size() == N;
  for (int i = 0; fits && i < N; ++i) {
    fits = (*found)[std::size_t(i)].is_number();
    if (fits) numbers[std::size_t(i)] = (*found)[std::size_t(i)];
  }
  if (!fits) document.fail(fmt::format("{}: accepted: {} numbers", key, N));
  return numbers;
}

Mat4 transform_of(const Json& node, const GltfDocument& document) {
  Mat4 m(1);
  if (const auto columns = numbers_of<16>(node, "matrix", document)) {
    for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = (*columns)[std::size_t(i)];
    return m;
  }
  if (const auto q = numbers_of<4>(node, "rotation", document)) {
    const glm::dquat turn((*q)[3], (*q)[0], (*q)[1], (*q)[2]);
    if (glm::length(turn) > 0) m = glm::mat4_cast(glm::normalize(turn));
  }
  if (const auto scale = numbers_of<3>(node, "scale", document))
    for (int axis = 0; axis < 3; ++axis) m[axis] *= (*scale)[std::size_t(axis)];
  if (const auto shift = numbers_of<3>(node, "translation", document))
    m[3] = glm::dvec4((*shift)[0], (*shift)[1], (*shift)[2], 1);
  return m;
}

class GltfReader {
 public:
  /// Takes the primitives of these modes.
  GltfReader(const std::filesystem::path& path, int first_mode, int last_mode)
      : document_(path), first_mode_(first_mode), last_mode_(last_mode) {}

  /// What is of another type than the format has it, such as a text for a list, is refused where it
  /// is used.
  Collected read() {
    try {
      return read_scene();
    } catch (const Json::exception& error) {
      document_.fail(fmt::format("not as glTF has it: {}", error.what()));
    }
  }

 private:
  Collected read_scene() {
    const Json& root = document_.root();
    if (const auto scenes = root.find("scenes"); scenes != root.end()) {
      const Json& scene = document_.element("scenes", root.value("scene", Json(0)));
      for (const Json& node : scene.value("nodes", Json::array())) read_node(node, Mat4(1), 0);
    } else {  // a library of meshes
      for (std::size_t i = 0; i < root.value("meshes", Json::array()).size(); ++i)
        read_mesh(Json(i), Json::object(), Mat4(1));
    }
    finish_attributes();
    return std::move(collected_);
  }

  void read_node(const Json& index, const Mat4& world_from_parent, int depth) {
    const Json& node = document_.element("nodes", index);
    constexpr int deepest = 1000;
    if (!visited_.insert(index.get<std::size_t>()).second || depth > deepest)
      document_.fail(fmt::format("nodes[{}] has two parents, or more than {} levels above it",
                                 index.dump(), deepest));
    const Mat4 world_from_node = world_from_parent * transform_of(node, document_);
    if (node.contains("mesh") && node.contains("skin"))
      document_.fail(
          fmt::format("nodes[{}] has a skin, which is not read; accepted: meshes as they stand, "
                      "with the pose applied",
                      index.dump()));
    if (node.contains("mesh")) read_mesh(node["mesh"], node, world_from_node);
    if (const auto children = node.find("children"); children != node.end())
      for (const Json& child : *children) read_node(child, world_from_node, depth + 1);
  }

  void read_mesh(const Json& index, const Json& node, const Mat4& world) {
    const Json& mesh = document_.element("meshes", index);
    weights_ = node.value("weights", mesh.value("weights", Json::array()));
    const auto primitives = mesh.find("primitives");
    if (primitives == mesh.end()) return;
    for (const Json& primitive : *primitives) {
      const Json mode = primitive.is_object() ? primitive.value("mode", Json(triangles)) : Json();
      if (!mode.is_number_integer() || mode < 0 || mode > 6)
        document_.fail(fmt::format("a primitive's mode {}; accepted: 0 … 6", mode.dump()));
      if (mode >= first_mode_ && mode <= last_mode_)
        read_primitive(primitive, Mode(mode.get<int>()), world);
    }
  }

  void read_primitive(const Json& primitive, Mode mode, const Mat4& world) {
    const Json attributes = primitive.value("attributes", Json::object());
    if (!attributes.is_object() || !attributes.contains("POSITION")) return;
    Vertices& all = collected_.vertices;
    const std::size_t first = all.positions.size();
    const AccessorData positions = morphed("POSITION", primitive, 3, 3);
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
    std::vector<Vec3>& normals = collected_.vertices.normals;
    const std::size_t first = normals.size();
    normals.resize(first + count, Vec3(0));
    if (!primitive["attributes"].contains("NORMAL")) return;
    has_normals_ = true;
    const AccessorData data = morphed("NORMAL", primitive, 3, 3);
    check_count(data, count, "NORMAL");
    const Mat3 of_normals = glm::transpose(glm::inverse(Mat3(world)));
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3 n = of_normals * Vec3(data.at(i, 0), data.at(i, 1), data.at(i, 2));
      const double length = glm::length(n);
      normals[first + i] = length > 0 ? n / length : Vec3(0);
    }
  }

  enum class Alpha { opaque, mask, blend };
  struct Material {
    glm::dvec4 factor{1};
    Alpha alpha = Alpha::opaque;
    double cutoff = 0.5;  // of a mask: the least alpha that is there
    bool is_given = false;
  };

  Alpha alpha_of(const Json& material) const {
    const Json mode = material.value("alphaMode", Json("OPAQUE"));
    if (mode == "OPAQUE") return Alpha::opaque;
    if (mode == "MASK") return Alpha::mask;
    if (mode != "BLEND")
      document_.fail(fmt::format("alphaMode {}; accepted: OPAQUE, MASK, BLEND", mode.dump()));
    return Alpha::blend;
  }

  Material material_of(const Json& primitive) const {
    Material material;
    if (!primitive.contains("material")) return material;
    material.is_given = true;
    const Json& given = document_.element("materials", primitive["material"]);
    material.alpha = alpha_of(given);
    material.cutoff = given.value("alphaCutoff", 0.5);
    if (const auto pbr = given.find("pbrMetallicRoughness"); pbr != given.end() && pbr->is_object())
      if (const auto factor = numbers_of<4>(*pbr, "baseColorFactor", document_))
        material.factor = {(*factor)[0], (*factor)[1], (*factor)[2], (*factor)[3]};
    return material;
  }

  void add_colors(const Json& primitive, std::size_t count) {
    const Material material = material_of(primitive);
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
      if (material.alpha == Alpha::opaque) color.a = 1;
      collected_.vertices.colors.emplace_back(color);
    }
    if (material.alpha == Alpha::mask) mask(material.cutoff, count);
  }

  /// Makes the alpha of the last `count` vertices 0 or 1. Where it lies on both sides of the cutoff
  /// the edge would run across triangles, which vertices cannot have.
  void mask(double cutoff, std::size_t count) {
    auto& colors = collected_.vertices.colors;
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
    std::string small = name.substr(1);
    std::ranges::transform(small, small.begin(), [](unsigned char c) { return std::tolower(c); });
    std::vector<double>& column = attributes_[small];
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

  void join(Mode mode, std::vector<std::uint32_t> corners, std::uint32_t first) {
    for (std::uint32_t& corner : corners) corner += first;
    const std::size_t n = corners.size();
    auto& all = collected_.triangles;
    auto& polylines = collected_.polylines;
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
    Vertices& vertices = collected_.vertices;
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

  GltfDocument document_;
  int first_mode_, last_mode_;
  Json weights_;                   // of the mesh's morph targets; none: of all 0
  std::set<std::size_t> visited_;  // nodes: each has one parent at most
  bool has_normals_ = false, has_colors_ = false;
  VertexAttributes attributes_;
  Collected collected_;
};

TriangleMesh read_gltf(const std::filesystem::path& path) {
  Collected all = GltfReader(path, triangles, fan).read();
  TriangleMesh mesh;
  static_cast<Vertices&>(mesh) = std::move(all.vertices);
  mesh.triangles = std::move(all.triangles);
  return mesh;
}

LineSet read_gltf_lines(const std::filesystem::path& path) {
  const Collected all = GltfReader(path, lines, line_strip).read();
  const auto pick = [&](const auto& from, auto& to) {
    if (from.empty()) return;
    for (const auto& polyline : all.polylines)
      for (const std::uint32_t i : polyline) to.push_back(from[i]);
  };
  LineSet set;
  pick(all.vertices.positions, set.positions);
  pick(all.vertices.colors, set.colors);
  pick(all.vertices.importance, set.importance);
  for (const auto& [name, column] : all.vertices.scalars) pick(column, set.scalars[name]);
  for (const auto& polyline : all.polylines)
    set.offsets.push_back(set.offsets.back() + polyline.size());
  return set;
}

PointSet read_gltf_points(const std::filesystem::path& path) {
  Collected all = GltfReader(path, points, fan).read();
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
          "_NAME of one number are scalars; morph targets by their weights; no textures, no "
          "compression; skins are refused",
      .read_mesh = read_gltf,
      .read_lines = read_gltf_lines,
      .read_points = read_gltf_points};
}

}  // namespace

FormatRow gltf_format() { return row(".gltf", "glTF 2.0"); }
FormatRow glb_format() { return row(".glb", "glTF 2.0, binary"); }

}  // namespace pellucid::geometry
