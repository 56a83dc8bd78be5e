// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/export/gltf.h"

#include <tiny_gltf.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <numbers>

#include "core/files/write_failure.h"

namespace pellucid::compare {
namespace {

using tinygltf::Value;

constexpr std::uint64_t largest_file = std::numeric_limits<std::uint32_t>::max();

std::uint64_t bytes_of(const ExportedObject& object) {
  const std::uint64_t per_vertex = sizeof(float) * (3 + 3 + 4 + object.radius.vary());
  return per_vertex * object.vertices.positions.size() +
         sizeof(std::uint32_t) * (3 * object.triangles.size() + 2 * object.edges.size());
}

bool fits(const std::vector<ExportedObject>& objects) {
  constexpr std::uint64_t per_object = 4096;  // of JSON, generously
  std::uint64_t bytes = 0;
  for (const ExportedObject& object : objects) bytes += bytes_of(object) + per_object;
  return bytes < largest_file;
}

/// What the format has no place for; radii that differ are the vertices' _RADIUS.
Value extras_of(const ExportedObject& object) {
  Value::Object extras{{"profile", Value(std::string(object.profile))}};
  if (!object.radius.vary()) extras["radius"] = Value(object.radius.largest());
  return Value(std::move(extras));
}

class GltfBuilder {
 public:
  GltfBuilder() {
    model_.asset.version = "2.0";
    model_.asset.generator = "pellucid";
    model_.buffers.emplace_back();
    model_.scenes.emplace_back();
    model_.defaultScene = 0;
  }

  void add_camera(const scene::Scene& scene, const CameraMatrices& m) {
    tinygltf::Camera camera;
    if (scene.camera.projection == scene::Projection::perspective) {
      camera.type = "perspective";
      camera.perspective.aspectRatio = m.aspect;
      camera.perspective.yfov = scene.camera.fov * std::numbers::pi / 180;
      camera.perspective.znear = m.near;
      camera.perspective.zfar = m.far;
    } else {
      camera.type = "orthographic";
      camera.orthographic.ymag = scene.camera.height / 2;
      camera.orthographic.xmag = m.aspect * camera.orthographic.ymag;
      camera.orthographic.znear = m.near;
      camera.orthographic.zfar = m.far;
    }
    model_.cameras.push_back(camera);
    tinygltf::Node node;
    node.name = "camera";
    node.camera = 0;
    const Mat4 world_from_view = glm::inverse(m.view);
    for (int column = 0; column < 4; ++column)
      for (int row = 0; row < 4; ++row) node.matrix.push_back(world_from_view[column][row]);
    add_node(node);
  }

  void add_object(const ExportedObject& object, const std::string& name) {
    tinygltf::Primitive primitive;
    primitive.mode = object.kind == "triangles" ? TINYGLTF_MODE_TRIANGLES
                     : object.kind == "lines"   ? TINYGLTF_MODE_LINE
                                                : TINYGLTF_MODE_POINTS;
    primitive.material = add_material(object);
    const geometry::Vertices& v = object.vertices;
    primitive.attributes["POSITION"] = add_vectors<3>(v.positions, TINYGLTF_TYPE_VEC3, true);
    if (!v.normals.empty())
      primitive.attributes["NORMAL"] = add_vectors<3>(v.normals, TINYGLTF_TYPE_VEC3, false);
    primitive.attributes["COLOR_0"] = add_vectors<4>(v.colors, TINYGLTF_TYPE_VEC4, false);
    if (object.radius.vary()) primitive.attributes["_RADIUS"] = add_radii(object);
    if (object.kind != "points") primitive.indices = add_indices(object);
    tinygltf::Mesh mesh;
    mesh.name = name;
    mesh.primitives.push_back(primitive);
    if (object.radius.largest() > 0) mesh.extras = extras_of(object);
    model_.meshes.push_back(mesh);
    tinygltf::Node node;
    node.name = name;
    node.mesh = int(model_.meshes.size()) - 1;
    add_node(node);
  }

  void write(const std::filesystem::path& path) {
    if (uses_unlit_) model_.extensionsUsed.emplace_back("KHR_materials_unlit");
    std::ofstream out(path, std::ios::binary);
    tinygltf::TinyGLTF writer;
    if (!writer.WriteGltfSceneToStream(&model_, out, false, true) || !out.flush())
      fail_stream(path);
  }

 private:
  void add_node(const tinygltf::Node& node) {
    model_.nodes.push_back(node);
    model_.scenes[0].nodes.push_back(int(model_.nodes.size()) - 1);
  }

  int add_material(const ExportedObject& object) {
    tinygltf::Material material;
    material.alphaMode = object.opaque ? "OPAQUE" : "BLEND";
    material.doubleSided = true;
    material.pbrMetallicRoughness.metallicFactor = 0;
    if (object.lit) material.extensions["KHR_materials_unlit"] = Value(Value::Object{});
    uses_unlit_ |= object.lit;
    model_.materials.push_back(material);
    return int(model_.materials.size()) - 1;
  }

  template <class T>
  void append(T value) {
    unsigned char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    std::vector<unsigned char>& data = model_.buffers[0].data;
    data.insert(data.end(), bytes, bytes + sizeof value);
  }

  /// The accessor of what is appended from `begin` on.
  int add_accessor(std::size_t begin, std::size_t count, int type, int component, int target) {
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = begin;
    view.byteLength = model_.buffers[0].data.size() - begin;
    view.target = target;
    model_.bufferViews.push_back(view);
    tinygltf::Accessor accessor;
    accessor.bufferView = int(model_.bufferViews.size()) - 1;
    accessor.componentType = component;
    accessor.count = count;
    accessor.type = type;
    model_.accessors.push_back(accessor);
    return int(model_.accessors.size()) - 1;
  }

  /// The format wants the bounds of positions, of the floats as they are written.
  template <int n, class Vector>
  int add_vectors(const std::vector<Vector>& vectors, int type, bool bounds) {
    const std::size_t begin = model_.buffers[0].data.size();
    std::vector<double> low(n, std::numeric_limits<double>::infinity()), high(n, -low[0]);
    for (const Vector& vector : vectors)
      for (int k = 0; k < n; ++k) {
        const auto value = float(vector[k]);
        append(value);
        low[std::size_t(k)] = std::min(low[std::size_t(k)], double(value));
        high[std::size_t(k)] = std::max(high[std::size_t(k)], double(value));
      }
    const int index = add_accessor(begin, vectors.size(), type, TINYGLTF_COMPONENT_TYPE_FLOAT,
                                   TINYGLTF_TARGET_ARRAY_BUFFER);
    if (bounds) {
      model_.accessors.back().minValues = low;
      model_.accessors.back().maxValues = high;
    }
    return index;
  }

  int add_radii(const ExportedObject& object) {
    std::vector<std::array<float, 1>> radii;
    for (std::size_t i = 0; i < object.vertices.positions.size(); ++i)
      radii.push_back({float(object.radius.at(i))});
    return add_vectors<1>(radii, TINYGLTF_TYPE_SCALAR, false);
  }

  int add_indices(const ExportedObject& object) {
    const std::size_t begin = model_.buffers[0].data.size();
    for (const std::array<std::uint32_t, 3>& triangle : object.triangles)
      for (const std::uint32_t corner : triangle) append(corner);
    for (const auto& [from, to] : object.edges) {
      append(from);
      append(to);
    }
    return add_accessor(begin, 3 * object.triangles.size() + 2 * object.edges.size(),
                        TINYGLTF_TYPE_SCALAR, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT,
                        TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
  }

  tinygltf::Model model_;
  bool uses_unlit_ = false;
};

}  // namespace

bool write_gltf(const std::filesystem::path& path, const scene::Scene& scene,
                const CameraMatrices& camera, const std::vector<ExportedObject>& objects) {
  if (!fits(objects)) return false;
  GltfBuilder builder;
  builder.add_camera(scene, camera);
  // The format has no meshes without vertices.
  for (std::size_t i = 0; i < objects.size(); ++i)
    if (objects[i].count() > 0) builder.add_object(objects[i], scene.objects[i].name);
  builder.write(path);
  return true;
}

}  // namespace pellucid::compare
