// SPDX-License-Identifier: GPL-3.0-or-later
// Connects the kernel's arrays directly: add_face() searches around three vertices for every face,
// and refuses what only further faces make a manifold.
#include "geometry/half_edges.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "core/error.h"

namespace pellucid::geometry {
namespace {

using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

bool is_folded(const Corners& triangle) {
  const auto& [a, b, c] = triangle;
  return a == b || b == c || c == a;
}

/// Side k of triangle f has the number 3 f + k, and runs from corner k to the next one.
class Builder {
 public:
  /// Fills in `result`, in its place: OpenMesh's meshes are copied where they are moved.
  Builder(std::span<const Vec3> positions, std::span<const Corners> triangles, HalfEdges& result)
      : positions_(positions),
        triangles_(triangles),
        half_edges_(3 * triangles.size(), none),
        result_(result) {}

  void build() {
    sort_sides();
    pair_sides();
    connect_faces();
    if (connect_vertices() < 3 * triangles_.size()) split_vertices();
  }

 private:
  struct Side {
    std::uint32_t high;      // the larger of its vertices
    std::uint32_t number;    // 3 f + k
    std::uint32_t previous;  // place of another one of the same edge, or none
    bool forward;            // runs from the smaller vertex to the larger one
  };

  template <class Use>
  void for_each_side(const Use& use) const;
  void sort_sides();
  void pair_sides();
  void pair_edge(std::uint32_t last);
  void open(std::uint32_t side) { half_edges_[side] = 2 * edges_++; }
  void connect_faces();
  std::size_t connect_vertices();
  void split_vertices();
  template <class Visit>
  HalfedgeHandle around(HalfedgeHandle first, const Visit& visit);

  HalfedgeHandle half_edge(std::size_t side) const {
    return HalfedgeHandle(int(half_edges_[side]));
  }
  SurfaceMesh::Point point(std::size_t vertex) const {
    const Vec3& x = positions_[vertex];
    return {x.x, x.y, x.z};
  }
  HalfedgeHandle next(HalfedgeHandle h) const { return mesh().next_halfedge_handle(h); }
  HalfedgeHandle previous(HalfedgeHandle h) const { return next(next(h)); }  // in a face
  static HalfedgeHandle opposite(HalfedgeHandle h) { return HalfedgeHandle(h.idx() ^ 1); }
  SurfaceMesh& mesh() { return result_.mesh; }
  const SurfaceMesh& mesh() const { return result_.mesh; }

  std::span<const Vec3> positions_;
  std::span<const Corners> triangles_;
  std::vector<std::uint32_t> begin_;       // where the sides of each smaller vertex begin
  std::vector<Side> sides_;                // by their smaller vertex
  std::vector<std::uint32_t> half_edges_;  // of each side
  std::uint32_t edges_ = 0;
  HalfEdges& result_;
};

/// Calls use(smaller vertex, larger vertex, side, forward) for all but those of folded triangles.
template <class Use>
void Builder::for_each_side(const Use& use) const {
  for (std::uint32_t f = 0; f < triangles_.size(); ++f) {
    if (is_folded(triangles_[f])) continue;
    const auto& [a, b, c] = triangles_[f];
    use(std::min(a, b), std::max(a, b), 3 * f, a < b);
    use(std::min(b, c), std::max(b, c), 3 * f + 1, b < c);
    use(std::min(c, a), std::max(c, a), 3 * f + 2, c < a);
  }
}

void Builder::sort_sides() {
  begin_.assign(positions_.size() + 2, 0);
  std::size_t count = 0;
  for_each_side([&](std::uint32_t low, std::uint32_t, std::uint32_t, bool) {
    ++begin_[low + 2];
    ++count;
  });
  for (std::size_t v = 2; v < begin_.size(); ++v) begin_[v] += begin_[v - 1];
  sides_.resize(count);
  for_each_side([&](std::uint32_t low, std::uint32_t high, std::uint32_t side, bool forward) {
    sides_[begin_[low + 1]++] = {high, side, none, forward};
  });
}

/// Among the sides of one smaller vertex, those with the same larger one are chained.
void Builder::pair_sides() {
  std::vector<std::uint32_t> last_with(positions_.size(), none);
  for (std::size_t v = 0; v < positions_.size(); ++v) {
    for (std::uint32_t i = begin_[v]; i < begin_[v + 1]; ++i)
      sides_[i].previous = std::exchange(last_with[sides_[i].high], i);
    for (std::uint32_t i = begin_[v]; i < begin_[v + 1]; ++i)
      if (const auto last = std::exchange(last_with[sides_[i].high], none); last != none)
        pair_edge(last);
  }
}

void Builder::pair_edge(std::uint32_t last) {
  const Side& side = sides_[last];
  if (side.previous == none) {
    ++result_.boundary_edges;
    return open(side.number);
  }
  const Side& other = sides_[side.previous];
  const bool more = other.previous != none;
  if (!more && side.forward != other.forward) {
    half_edges_[other.number] = 2 * edges_;
    half_edges_[side.number] = 2 * edges_++ + 1;
    return;
  }
  ++(more ? result_.non_manifold_edges : result_.misoriented_edges);
  for (std::uint32_t i = last; i != none; i = sides_[i].previous) {
    open(sides_[i].number);
    if (const std::uint32_t before = sides_[i].previous; before != none)
      result_.apart.push_back({sides_[before].number / 3, sides_[i].number / 3});
  }
}

void Builder::connect_faces() {
  for (std::uint32_t f = 0; f < triangles_.size(); ++f)
    if (is_folded(triangles_[f])) {
      ++result_.folded_triangles;
      result_.boundary_edges += 3;
      for (std::uint32_t k = 0; k < 3; ++k) open(3 * f + k);
    }
  mesh().resize(positions_.size(), edges_, triangles_.size());
  for (std::size_t f = 0; f < triangles_.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const HalfedgeHandle h = half_edge(3 * f + k);
      const VertexHandle from{int(triangles_[f][k])}, to{int(triangles_[f][(k + 1) % 3])};
      mesh().set_face_handle(h, FaceHandle(int(f)));
      mesh().set_vertex_handle(h, to);
      mesh().set_vertex_handle(opposite(h), from);
      mesh().set_next_halfedge_handle(h, half_edge(3 * f + (k + 1) % 3));
      mesh().set_halfedge_handle(from, h);
    }
    mesh().set_halfedge_handle(FaceHandle(int(f)), half_edge(3 * f + 2));
  }
}

/// Visits the faces' half-edges that leave the vertex in one fan, and connects its border there.
/// Returns the half-edge that is to be the vertex's: on the border if there is one.
template <class Visit>
HalfedgeHandle Builder::around(HalfedgeHandle first, const Visit& visit) {
  visit(first);
  HalfedgeHandle leaving = opposite(previous(first));
  for (; !mesh().is_boundary(leaving); leaving = opposite(previous(leaving))) {
    if (leaving == first) return first;
    visit(leaving);
  }
  HalfedgeHandle arriving = opposite(first);
  for (; !mesh().is_boundary(arriving); arriving = opposite(next(arriving))) visit(next(arriving));
  mesh().set_next_halfedge_handle(arriving, leaving);
  return leaving;
}

/// Returns how many corners are in the fans that the vertices have: all, unless several fans meet.
std::size_t Builder::connect_vertices() {
  std::size_t corners = 0;
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    const VertexHandle v{int(i)};
    mesh().set_point(v, point(i));
    if (mesh().is_isolated(v)) continue;
    const auto count = [&](HalfedgeHandle) { ++corners; };
    mesh().set_halfedge_handle(v, around(mesh().halfedge_handle(v), count));
  }
  return corners;
}

/// The first fan in the order of the triangles keeps the vertex.
void Builder::split_vertices() {
  std::vector<bool> visited(mesh().n_halfedges());
  std::vector<std::uint8_t> fans(positions_.size());  // 2: or more
  for (std::size_t side = 0; side < half_edges_.size(); ++side) {
    const HalfedgeHandle h = half_edge(side);
    if (visited[std::size_t(h.idx())]) continue;
    const std::uint32_t given = triangles_[side / 3][side % 3];
    VertexHandle v{int(given)};
    if (fans[given] > 0) {
      v = mesh().add_vertex(point(given));
      result_.copied.push_back(given);
      result_.non_manifold_vertices += fans[given] == 1;
    }
    fans[given] = std::min(fans[given] + 1, 2);
    mesh().set_halfedge_handle(v, around(h, [&](HalfedgeHandle leaving) {
                                 visited[std::size_t(leaving.idx())] = true;
                                 mesh().set_vertex_handle(previous(leaving), v);
                                 mesh().set_vertex_handle(opposite(leaving), v);
                               }));
  }
}

}  // namespace

HalfEdges half_edges(std::span<const Vec3> positions, std::span<const Corners> triangles) {
  constexpr auto most = std::size_t(std::numeric_limits<int>::max()) / 6;  // handles are ints
  if (triangles.size() > most)
    throw InputError(
        fmt::format("{} triangles; a half-edge mesh has at most {}", triangles.size(), most));
  HalfEdges result;
  Builder(positions, triangles, result).build();
  return result;
}

HalfEdges half_edges(const TriangleMesh& mesh) {
  return half_edges(mesh.positions, mesh.triangles);
}

}  // namespace pellucid::geometry
