// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/appearance/face_scalars.h"

#include <bit>
#include <optional>

#include "core/options/names.h"

namespace pellucid::scene {
namespace {

/// Appends a copy of vertex i with all that it carries.
void copy_vertex(std::uint32_t i, geometry::Vertices& vertices) {
  const auto copy = [i](auto& values) {
    if (values.empty()) return;
    const auto value = values[i];
    values.push_back(value);
  };
  copy(vertices.positions);
  copy(vertices.normals);
  copy(vertices.colors);
  copy(vertices.importance);
  for (auto& [name, values] : vertices.scalars) copy(values);
}

/// The vertex that stands for another one at faces of one value: itself for the first value that it
/// is asked for, else a copy.
class VerticesByValue {
 public:
  explicit VerticesByValue(geometry::TriangleMesh& mesh)
      : mesh_(mesh), first_(mesh.positions.size()) {}

  std::uint32_t vertex(std::uint32_t corner, double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    std::optional<std::uint64_t>& first = first_[corner];
    if (!first) first = bits;
    if (*first == bits) return corner;
    const auto next = std::uint32_t(mesh_.positions.size());
    const auto [found, is_new] = further_.try_emplace({corner, bits}, next);
    if (is_new) copy_vertex(corner, mesh_);
    return found->second;
  }

 private:
  geometry::TriangleMesh& mesh_;
  std::vector<std::optional<std::uint64_t>> first_;  // the value's bits, by vertex
  std::map<std::pair<std::uint32_t, std::uint64_t>, std::uint32_t> further_;
};

void bring_to_vertices(const std::string& name, geometry::TriangleMesh& mesh) {
  ensure_normals(mesh);  // of the faces as they meet now
  const std::vector<double>& values = mesh.face_scalars.at(name);
  VerticesByValue vertices(mesh);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for (std::uint32_t& corner : mesh.triangles[i]) corner = vertices.vertex(corner, values[i]);
  std::vector<double> of_vertices(mesh.positions.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for (const std::uint32_t corner : mesh.triangles[i]) of_vertices[corner] = values[i];
  mesh.scalars[name] = std::move(of_vertices);
}

[[noreturn]] void refuse(const std::string& name, const geometry::TriangleMesh& mesh) {
  std::vector<std::string_view> known;
  for (const auto& [scalar, values] : mesh.scalars) known.push_back(scalar);
  for (const auto& [scalar, values] : mesh.face_scalars)
    if (!mesh.scalars.contains(scalar)) known.push_back(scalar);
  throw InputError(unknown_name("scalar", name, known));
}

}  // namespace

void bring_to_vertices(const Appearance& appearance, geometry::TriangleMesh& mesh) {
  for (const std::string& name : scalars_of(appearance)) {
    if (mesh.scalars.contains(name)) continue;
    if (!mesh.face_scalars.contains(name)) refuse(name, mesh);
    bring_to_vertices(name, mesh);
  }
}

}  // namespace pellucid::scene
