// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Half-edge connectivity by OpenMesh. A heavy header: include it in .cpp files alone.

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <array>
#include <cstdint>

#include "geometry/triangle_mesh.h"

namespace pellucid::geometry {

/// Half-edges carry no link to the one before: of a face it is the one after the next.
struct SurfaceMeshTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  VertexAttributes(0);
  HalfedgeAttributes(0);
  EdgeAttributes(0);
  FaceAttributes(0);
};

/// A SurfaceMesh is what half_edges() joins triangles to (geometry/half_edges.h).
using SurfaceMesh = OpenMesh::TriMesh_ArrayKernelT<SurfaceMeshTraits>;

/// The numbers of the vertices of a triangle.
using Corners = std::array<std::uint32_t, 3>;

/// Positions and triangles of a mesh without deleted elements: garbage_collection() takes them out.
TriangleMesh triangle_mesh(const SurfaceMesh& mesh);

/// A face's three half-edges: the k-th one leaves its corner k.
inline std::array<OpenMesh::HalfedgeHandle, 3> sides(const SurfaceMesh& mesh,
                                                     OpenMesh::FaceHandle face) {
  const OpenMesh::HalfedgeHandle last = mesh.halfedge_handle(face);
  const OpenMesh::HalfedgeHandle first = mesh.next_halfedge_handle(last);
  return {first, mesh.next_halfedge_handle(first), last};
}

/// The numbers of a face's vertices.
inline Corners corners(const SurfaceMesh& mesh, OpenMesh::FaceHandle face) {
  const auto [first, second, last] = sides(mesh, face);
  const auto end = [&](OpenMesh::HalfedgeHandle h) {
    return std::uint32_t(mesh.to_vertex_handle(h).idx());
  };
  return {end(last), end(first), end(second)};
}

/// Puts an isolated vertex v on the edge of a half-edge from a to b, which has a face (a, b, c) and
/// may have a face (b, a, d) on its other side. They become (a, v, c) and (b, v, d); the new faces
/// are (v, b, c) and then (v, a, d). Returns the faces on each side, an old one and the new one;
/// those beyond a border are invalid.
std::array<OpenMesh::FaceHandle, 4> split_edge(SurfaceMesh& mesh, OpenMesh::HalfedgeHandle edge,
                                               OpenMesh::VertexHandle v);

}  // namespace pellucid::geometry
