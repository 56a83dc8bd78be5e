// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/files/face_colors.h"

#include <array>
#include <bit>
#include <map>
#include <type_traits>
#include <utility>

namespace pellucid::geometry {
namespace {

/// Whether vertices' alphas count, which have to be there and to have no rival.
bool keeps_alpha(const FaceColors& faces, FileMesh& mesh) {
  if (mesh.colors.empty()) return false;
  if (faces.have_alpha)
    mesh.remarks.push_back("the alpha of its vertices is left out: its faces have one, too");
  return !faces.have_alpha;
}

}  // namespace

void color_faces(const FaceColors& faces, FileMesh& mesh) {
  for (const auto& [name, values] : mesh.scalars) mesh.values.try_emplace(name, values);
  using Bits = std::array<std::uint32_t, 4>;  // which are in an order even where a colour is NaN
  std::map<std::pair<std::uint32_t, Bits>, std::uint32_t> vertices;
  std::vector<std::uint32_t> origins;  // by new vertex
  std::vector<Rgba> of_vertices;
  const bool alphas = keeps_alpha(faces, mesh);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (std::uint32_t& corner : mesh.triangles[i]) {
      Rgba color = faces.colors[i];
      if (alphas) color.a = mesh.colors[corner].a;
      const auto [found, is_new] =
          vertices.try_emplace({corner, std::bit_cast<Bits>(color)}, std::uint32_t(origins.size()));
      if (is_new) {
        origins.push_back(corner);
        of_vertices.push_back(color);
      }
      corner = found->second;
    }
  }
  const auto pick = [&](auto& values) {
    if (values.empty()) return;
    std::remove_reference_t<decltype(values)> picked;
    picked.reserve(origins.size());
    for (const std::uint32_t origin : origins) picked.push_back(values[origin]);
    values = std::move(picked);
  };
  pick(mesh.positions);
  pick(mesh.normals);
  pick(mesh.importance);
  for (auto& [name, values] : mesh.scalars) pick(values);
  mesh.colors = std::move(of_vertices);
}

void take_face_values(std::map<std::string, std::vector<double>> values, FileMesh& mesh) {
  for (auto& [name, column] : values)
    if (!mesh.scalars.contains(name)) mesh.values[name] = std::move(column);
}

}  // namespace pellucid::geometry
