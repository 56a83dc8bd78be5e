// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Half-edge connectivity by OpenMesh. A heavy header: include it in .cpp files alone.

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

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

using SurfaceMesh = OpenMesh::TriMesh_ArrayKernelT<SurfaceMeshTraits>;
using Corners = std::array<std::uint32_t, 3>;

/// The half-edge mesh of any triangles, each of which is a face of it exactly once, under its own
/// number and with the same first corner.
///
/// An edge joins the two triangles that have it when no third one has it and they run along it in
/// opposite directions, as those of an oriented surface do. At any other edge of several triangles
/// each of them has a border, and a triangle that repeats a vertex has three borders. A vertex at
/// which the triangles then hang together in several fans is split: the fan of its first triangle
/// keeps it, and every other one has a copy, which is numbered after the given vertices.
struct HalfEdges {
  SurfaceMesh mesh;                   // with the positions; vertices of no triangle are isolated
  std::vector<std::uint32_t> copied;  // the given vertices that those beyond them are copies of
  std::vector<std::array<std::uint32_t, 2>> apart;  // triangles that share an edge and are not
                                                    // joined there; n at one edge are n - 1 pairs

  // Of the given triangles:
  std::uint64_t boundary_edges = 0;         // of one triangle
  std::uint64_t non_manifold_edges = 0;     // of more than two
  std::uint64_t misoriented_edges = 0;      // of two that run along it the same way
  std::uint64_t folded_triangles = 0;       // that repeat a vertex; their edges count as boundary
  std::uint64_t non_manifold_vertices = 0;  // that were split

  /// Whether nothing had to be kept apart: the triangles are an oriented manifold.
  bool is_manifold() const { return copied.empty() && apart.empty() && folded_triangles == 0; }
};

/// Joins triangles, whose corners are below the number of positions, in time linear in both.
HalfEdges half_edges(std::span<const Vec3> positions, std::span<const Corners> triangles);
HalfEdges half_edges(const TriangleMesh& mesh);

/// Positions and triangles.
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
