// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/surface_mesh.h"

namespace pellucid::geometry {

using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;

TriangleMesh triangle_mesh(const SurfaceMesh& surface) {
  TriangleMesh mesh;
  for (const auto vertex : surface.vertices()) {
    const auto& x = surface.point(vertex);
    mesh.positions.emplace_back(x[0], x[1], x[2]);
  }
  for (const auto face : surface.faces()) mesh.triangles.push_back(corners(surface, face));
  return mesh;
}

// When all is done h runs from a to v and `rest` from v to b; `cut` runs from v to c and
// `cut_beyond` from v to d.
std::array<FaceHandle, 4> split_edge(SurfaceMesh& mesh, HalfedgeHandle h, VertexHandle v) {
  const auto join = [&](FaceHandle face, HalfedgeHandle first, HalfedgeHandle second,
                        HalfedgeHandle last) {
    mesh.set_next_halfedge_handle(first, second);
    mesh.set_next_halfedge_handle(second, last);
    mesh.set_next_halfedge_handle(last, first);
    for (const HalfedgeHandle each : {first, second, last}) mesh.set_face_handle(each, face);
    mesh.set_halfedge_handle(face, last);
  };
  const auto opposite = [&](HalfedgeHandle each) { return mesh.opposite_halfedge_handle(each); };
  const HalfedgeHandle o = opposite(h);
  const VertexHandle b = mesh.to_vertex_handle(h);
  const bool border = mesh.is_boundary(o);
  const HalfedgeHandle before = border ? mesh.prev_halfedge_handle(o) : HalfedgeHandle();
  const HalfedgeHandle rest = mesh.new_edge(v, b);
  mesh.set_vertex_handle(h, v);
  mesh.set_halfedge_handle(v, border ? o : rest);
  if (mesh.halfedge_handle(b) == o) mesh.set_halfedge_handle(b, opposite(rest));

  const FaceHandle face = mesh.face_handle(h), added = mesh.new_face();
  const HalfedgeHandle bc = mesh.next_halfedge_handle(h), ca = mesh.next_halfedge_handle(bc);
  const HalfedgeHandle cut = mesh.new_edge(v, mesh.to_vertex_handle(bc));
  join(face, h, cut, ca);
  join(added, rest, bc, opposite(cut));
  if (border) {
    mesh.set_next_halfedge_handle(before, opposite(rest));
    mesh.set_next_halfedge_handle(opposite(rest), o);
    return {face, added, FaceHandle(), FaceHandle()};
  }
  const FaceHandle beyond = mesh.face_handle(o), added_beyond = mesh.new_face();
  const HalfedgeHandle ad = mesh.next_halfedge_handle(o), db = mesh.next_halfedge_handle(ad);
  const HalfedgeHandle cut_beyond = mesh.new_edge(v, mesh.to_vertex_handle(ad));
  join(beyond, opposite(rest), cut_beyond, db);
  join(added_beyond, o, ad, opposite(cut_beyond));
  return {face, added, beyond, added_beyond};
}

}  // namespace pellucid::geometry
