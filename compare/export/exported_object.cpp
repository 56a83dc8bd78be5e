// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/export/exported_object.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/error.h"
#include "core/files/output_file.h"

namespace pellucid::compare {
namespace {

using scene::LineObject;
using scene::PointObject;

ExportedObject exported(const geometry::TriangleMesh& mesh) {
  ExportedObject object{.kind = "triangles", .vertices = mesh};
  object.triangles = mesh.triangles;
  return object;
}

ExportedObject exported(const LineObject& lines) {
  const bool tube = lines.profile == LineObject::Profile::tube;
  ExportedObject object{.kind = "lines",
                        .profile = tube ? "tube" : "ribbon",
                        .radius = lines.radius,
                        .vertices = lines.set};
  for (std::uint32_t k = 0; k < lines.set.line_count(); ++k)
    for (std::uint64_t i = lines.set.offsets[k]; i < lines.set.offsets[k + 1]; ++i) {
      object.line.push_back(k);
      if (i > lines.set.offsets[k])
        object.edges.emplace_back(std::uint32_t(i - 1), std::uint32_t(i));
    }
  return object;
}

ExportedObject exported(const PointObject& points) {
  const bool sphere = points.profile == PointObject::Profile::sphere;
  return {.kind = "points",
          .profile = sphere ? "sphere" : "disc",
          .radius = points.radius,
          .vertices = points.set};
}

ExportedObject exported(const scene::Isosurface&) {
  throw InputError("an isosurface that is no mesh; accepted: \"isosurface\": {…, \"mesh\": true}");
}

/// |n · v|, as the exact renderer has it.
double facing(const Vec3& normal, const Vec3& forward) {
  const double length = glm::length(normal);
  return length > 0 ? std::abs(glm::dot(normal, forward)) / length : 0;
}

bool has_flat_triangles(const ExportedObject& object) {
  const std::vector<Vec3>& n = object.vertices.normals;
  return object.kind == "triangles" &&
         std::ranges::all_of(object.triangles, [&](const std::array<std::uint32_t, 3>& t) {
           return n[t[0]] == n[t[1]] && n[t[1]] == n[t[2]];
         });
}

/// The colour in the light before it is cut off at 1, which would not be linear over a triangle.
bool is_cut_off(const Vec3& color) { return color.r == 1 || color.g == 1 || color.b == 1; }

void put_light_in(const scene::Scene& scene, scene::Lighting lighting, ExportedObject& object) {
  object.lit = lighting == scene::Lighting::none;
  const bool parallel = scene.camera.projection == scene::Projection::orthographic;
  if (object.lit || !parallel || !has_flat_triangles(object)) return;
  const Vec3 forward = scene::camera_frame(scene.camera).forward;
  std::vector<Rgba> colors = object.vertices.colors;
  for (std::size_t i = 0; i < colors.size(); ++i) {
    const Vec3 lit =
        scene::lit(lighting, Vec3(colors[i]), facing(object.vertices.normals[i], forward));
    if (lighting == scene::Lighting::phong && is_cut_off(lit)) return;
    colors[i] = Rgba(lit, colors[i].a);
  }
  object.vertices.colors = std::move(colors);
  object.lit = true;
}

/// PLY and glTF hold floats, of which the largest is 3.4e38; a scene's doubles may lie beyond.
void check_floats(const ExportedObject& object) {
  constexpr double most = std::numeric_limits<float>::max();
  const auto fits = [](const Vec3& x) {
    return std::abs(x.x) <= most && std::abs(x.y) <= most && std::abs(x.z) <= most;
  };
  if (std::ranges::all_of(object.vertices.positions, fits) && object.radius.largest() <= most)
    return;
  throw InputError(
      "a coordinate, or a radius, is beyond what the files' floats hold; accepted: at most "
      "3.4e38, as by \"transform\": {\"scale\": …}");
}

template <class T>
void append(std::string& out, T value) {
  char bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  out.append(bytes, sizeof value);
}

template <class Vector>
void append_floats(std::string& out, const Vector& vector) {
  for (int k = 0; k < Vector::length(); ++k) append(out, float(vector[k]));
}

std::string floats(std::initializer_list<std::string_view> names) {
  std::string text;
  for (const std::string_view name : names) text += fmt::format("property float {}\n", name);
  return text;
}

std::string header_of(const ExportedObject& object) {
  const geometry::Vertices& v = object.vertices;
  std::string text =
      fmt::format("ply\nformat binary_little_endian 1.0\nelement vertex {}\n", v.positions.size()) +
      floats({"x", "y", "z"});
  if (!v.normals.empty()) text += floats({"nx", "ny", "nz"});
  text += floats({"red", "green", "blue", "alpha"});
  if (!v.importance.empty()) text += floats({"importance"});
  if (object.radius.vary()) text += floats({"radius"});
  if (object.kind == "lines")
    text += fmt::format(
        "property uint line\nelement edge {}\nproperty uint vertex1\nproperty uint vertex2\n",
        object.edges.size());
  if (object.kind == "triangles")
    text += fmt::format("element face {}\nproperty list uchar uint vertex_indices\n",
                        object.triangles.size());
  return text + "end_header\n";
}

void append_vertex(std::string& out, const ExportedObject& object, std::size_t i) {
  const geometry::Vertices& v = object.vertices;
  append_floats(out, v.positions[i]);
  if (!v.normals.empty()) append_floats(out, v.normals[i]);
  append_floats(out, v.colors[i]);
  if (!v.importance.empty()) append(out, v.importance[i]);
  if (object.radius.vary()) append(out, float(object.radius.at(i)));
  if (object.kind == "lines") append(out, object.line[i]);
}

}  // namespace

std::size_t ExportedObject::count() const {
  if (kind == "triangles") return triangles.size();
  return kind == "lines" ? edges.size() : vertices.positions.size();
}

ExportedObject exported_object(const scene::Scene& scene, std::size_t index) {
  const scene::SceneObject& given = scene.objects[index];
  try {
    ExportedObject object =
        std::visit([](const auto& shape) { return exported(shape); }, given.shape);
    check_floats(object);
    object.opaque = given.opaque;
    put_light_in(scene, scene::lighting_of(scene, given), object);
    return object;
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", given.name, error.what()));
  }
}

double float_rounding(const ExportedObject& object) {
  double largest = 0;
  for (const Vec3& x : object.vertices.positions) {
    const Vec3 off = x - Vec3(glm::vec3(x));
    largest = std::max(largest, std::hypot(off.x, off.y, off.z));  // whose squares may be 0
  }
  return largest;
}

void write_exported_ply(const std::filesystem::path& path, const ExportedObject& object) {
  std::string out = header_of(object);
  for (std::size_t i = 0; i < object.vertices.positions.size(); ++i) append_vertex(out, object, i);
  for (const auto& [from, to] : object.edges) {
    append(out, from);
    append(out, to);
  }
  for (const std::array<std::uint32_t, 3>& triangle : object.triangles) {
    append(out, std::uint8_t(3));
    for (const std::uint32_t corner : triangle) append(out, corner);
  }
  write_text(path, out);
}

}  // namespace pellucid::compare
