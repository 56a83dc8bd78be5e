// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Half-edge connectivity by OpenMesh. A heavy header: include it in .cpp files alone.

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <optional>

#include "geometry/triangle_mesh.h"

namespace pellucid::geometry {

struct SurfaceMeshTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  VertexAttributes(0);
  HalfedgeAttributes(0);
  EdgeAttributes(0);
  FaceAttributes(0);
};

/// Vertex and face handles have the indices of the TriangleMesh it was made from.
using SurfaceMesh = OpenMesh::TriMesh_ArrayKernelT<SurfaceMeshTraits>;

/// Nothing when the triangles are no manifold: an edge with three faces or with two that run along
/// it in the same direction, a vertex where two fans meet, a triangle that repeats a vertex.
std::optional<SurfaceMesh> surface_mesh(const TriangleMesh& mesh);

/// Positions and triangles.
TriangleMesh triangle_mesh(const SurfaceMesh& mesh);

}  // namespace pellucid::geometry
