// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/surface_mesh.h"

#include <OpenMesh/Core/Utils/vector_cast.hh>

namespace pellucid::geometry {
namespace {

/// OpenMesh reports faces it refuses on its own stream; the caller is told by the result.
class QuietOpenMesh {
 public:
  QuietOpenMesh() { omerr().disable(); }
  ~QuietOpenMesh() { omerr().enable(); }
};

}  // namespace

std::optional<SurfaceMesh> surface_mesh(const TriangleMesh& mesh) {
  const QuietOpenMesh quiet;
  SurfaceMesh surface;
  surface.reserve(mesh.positions.size(), mesh.triangles.size() * 3 / 2, mesh.triangles.size());
  for (const Vec3& x : mesh.positions) surface.add_vertex({x.x, x.y, x.z});
  for (const auto& [a, b, c] : mesh.triangles) {
    if (a == b || b == c || c == a) return std::nullopt;
    const auto vertex = [&](std::uint32_t i) { return surface.vertex_handle(i); };
    if (!surface.add_face(vertex(a), vertex(b), vertex(c)).is_valid()) return std::nullopt;
  }
  for (const auto vertex : surface.vertices())
    if (!surface.is_manifold(vertex)) return std::nullopt;
  return surface;
}

TriangleMesh triangle_mesh(const SurfaceMesh& surface) {
  TriangleMesh mesh;
  for (const auto vertex : surface.vertices()) {
    const auto& x = surface.point(vertex);
    mesh.positions.emplace_back(x[0], x[1], x[2]);
  }
  for (const auto face : surface.faces()) {
    std::array<std::uint32_t, 3> corners;
    auto corner = surface.cfv_iter(face);
    for (std::uint32_t& index : corners) index = std::uint32_t((corner++)->idx());
    mesh.triangles.push_back(corners);
  }
  return mesh;
}

}  // namespace pellucid::geometry
