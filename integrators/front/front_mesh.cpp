// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/front/front_mesh.h"

namespace pellucid::integrators {

FrontMesh::FrontMesh(SurfaceBuilder& builder)
    : builder_(builder),
      given_(builder.vertex_count()),
      joined_(geometry::half_edges(builder.positions(), builder.triangles())) {}

void FrontMesh::push_neighbours(Facet facet, std::vector<Facet>& facets) const {
  for (const Edge edge : sides(facet))
    if (!is_on_border(edge)) facets.push_back(neighbour(edge));
}

bool FrontMesh::turn(Edge edge) {
  const auto whole = mesh_.edge_handle(edge);
  if (!mesh_.is_flip_ok(whole)) return false;
  mesh_.flip(whole);
  return true;
}

OpenMesh::VertexHandle FrontMesh::add_vertex(const FrontPoint& point, double s) {
  joined_.copied.push_back(builder_.add_vertex(point, s));
  const Vec3& x = point.flow.x;
  return mesh_.add_vertex({x.x, x.y, x.z});
}

bool FrontMesh::can_remove(Facet facet) const {
  int border_edges = 0;
  Edge last;
  for (const Edge edge : sides(facet))
    if (is_on_border(edge)) ++border_edges, last = edge;
  if (border_edges != 1) return border_edges > 1;
  return !mesh_.is_boundary(mesh_.to_vertex_handle(mesh_.next_halfedge_handle(last)));
}

void FrontMesh::remove(Facet facet) {
  if (removed_++ == 0) {
    mesh_.request_face_status();
    mesh_.request_edge_status();
    mesh_.request_vertex_status();
  }
  mesh_.delete_face(facet);
}

std::vector<std::optional<geometry::Corners>> FrontMesh::facets() const {
  std::vector<std::optional<geometry::Corners>> all;
  for (const Facet facet : mesh_.all_faces())
    all.push_back(is_removed(facet) ? std::nullopt : std::optional(corners(facet)));
  return all;
}

}  // namespace pellucid::integrators
