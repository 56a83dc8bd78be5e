// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A heavy header, by OpenMesh: include it in .cpp files alone.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/half_edges.h"
#include "integrators/front/surface_builder.h"

namespace pellucid::integrators {

/// The half-edge mesh of what a builder has collected, for edits that keep it a manifold. Vertices
/// are named by their numbers in the builder, which gets new ones at once; triangles are for
/// who edits to hand back.
class FrontMesh {
 public:
  using Facet = OpenMesh::FaceHandle;
  using Edge = OpenMesh::HalfedgeHandle;

  /// `builder` must outlive it.
  explicit FrontMesh(SurfaceBuilder& builder);
  FrontMesh(const FrontMesh&) = delete;

  std::uint32_t from(Edge edge) const { return number(mesh_.from_vertex_handle(edge)); }
  std::uint32_t to(Edge edge) const { return number(mesh_.to_vertex_handle(edge)); }
  /// The third corner of the facet on the edge's own side.
  std::uint32_t apex(Edge edge) const { return to(mesh_.next_halfedge_handle(edge)); }
  Edge opposite(Edge edge) const { return mesh_.opposite_halfedge_handle(edge); }
  /// Whether no facet is on the other side of the edge.
  bool is_on_border(Edge edge) const { return mesh_.is_boundary(opposite(edge)); }
  /// The facet on the other side of the edge; there must be one.
  Facet neighbour(Edge edge) const { return mesh_.face_handle(opposite(edge)); }

  std::size_t facet_count() const { return mesh_.n_faces(); }  // removed ones, too
  std::array<Edge, 3> sides(Facet facet) const { return geometry::sides(mesh_, facet); }
  geometry::Corners corners(Facet facet) const {
    const auto [first, second, last] = sides(facet);
    return {to(last), to(first), to(second)};
  }
  void push_neighbours(Facet facet, std::vector<Facet>& facets) const;

  /// Replaces the edge by the other diagonal of its two facets, which keep their numbers. False on
  /// the border, and where the other diagonal is an edge already.
  bool turn(Edge edge);
  /// Puts a vertex on the edge, a point of the surface whose particle starts at s, and calls
  /// use(facet) for the facets around it then.
  template <class Use>
  void split(Edge edge, const FrontPoint& point, double s, const Use& use) {
    for (const Facet part : geometry::split_edge(mesh_, edge, add_vertex(point, s)))
      if (part.is_valid()) use(part);
  }
  /// Whether a facet on the border may go: not where two parts would then meet in a vertex alone.
  bool can_remove(Facet facet) const;
  void remove(Facet facet);
  bool is_removed(Facet facet) const { return removed_ > 0 && mesh_.status(facet).deleted(); }

  /// Returns the corners of all facets by their numbers: nothing of those that are removed.
  std::vector<std::optional<geometry::Corners>> facets() const;

 private:
  std::uint32_t number(OpenMesh::VertexHandle v) const {
    const auto i = std::size_t(v.idx());
    return i < given_ ? std::uint32_t(i) : joined_.copied[i - given_];
  }
  OpenMesh::VertexHandle add_vertex(const FrontPoint& point, double s);

  SurfaceBuilder& builder_;
  std::size_t given_;           // vertices there were
  geometry::HalfEdges joined_;  // its `copied` goes on with the numbers of new vertices
  geometry::SurfaceMesh& mesh_ = joined_.mesh;
  std::size_t removed_ = 0;
};

}  // namespace pellucid::integrators
