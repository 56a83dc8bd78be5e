// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/mesh/triangle_links.h"

#include <cassert>

namespace pellucid::integrators {

TriangleLinks::TriangleLinks(std::vector<Triangle>& triangles, std::size_t vertex_count)
    : triangles_(triangles), links_(triangles.size(), {none, none, none}) {
  // Edges by the vertex they leave: those of v are at begin[v] and after.
  std::vector<std::uint32_t> begin(vertex_count + 2);
  for (const Triangle& triangle : triangles)
    for (const std::uint32_t v : triangle) ++begin[v + 2];
  for (std::size_t v = 2; v < begin.size(); ++v) begin[v] += begin[v - 1];
  std::vector<std::uint32_t> edges(3 * triangles.size());
  for (std::uint32_t i = 0; i < edges.size(); ++i) edges[begin[triangles[i / 3][i % 3] + 1]++] = i;
  for (std::uint32_t i = 0; i < edges.size(); ++i) {
    const std::uint32_t a = triangles[i / 3][i % 3], b = corner(i / 3, int(i % 3) + 1);
    for (std::uint32_t j = begin[b]; j < begin[b + 1]; ++j)
      if (corner(edges[j] / 3, int(edges[j] % 3) + 1) == a) links_[i / 3][i % 3] = edges[j] / 3;
  }
}

TriangleLinks::Edge TriangleLinks::edge_from(std::uint32_t triangle, std::uint32_t vertex) const {
  const Triangle& corners = triangles_[triangle];
  const int k = corners[0] == vertex ? 0 : corners[1] == vertex ? 1 : 2;
  assert(corners[std::size_t(k)] == vertex);
  return {triangle, k};
}

TriangleLinks::Edge TriangleLinks::twin(const Edge& edge) const {
  return edge_from(neighbour(edge), to(edge));
}

/// Walks around the vertex a that the edge leaves.
bool TriangleLinks::are_joined(const Edge& edge_from_a, std::uint32_t b) const {
  const std::uint32_t a = from(edge_from_a);
  Edge edge = edge_from_a;
  while (true) {  // to the right: over the edge that leaves a
    if (to(edge) == b || opposite(edge) == b) return true;
    if (neighbour(edge) == none) break;
    edge = edge_from(neighbour(edge), a);
    if (edge.triangle == edge_from_a.triangle) return false;
  }
  edge = edge_from_a;
  while (true) {  // and to the left, over the one that arrives there
    const std::uint32_t next = neighbour({edge.triangle, edge.k + 2});
    if (next == none) return false;
    edge = edge_from(next, a);
    if (to(edge) == b || opposite(edge) == b) return true;
  }
}

bool TriangleLinks::can_turn(const Edge& edge) const {
  if (neighbour(edge) == none) return false;
  return !are_joined({edge.triangle, (edge.k + 2) % 3}, opposite(twin(edge)));
}

/// The vertex that the edge leaves.
bool TriangleLinks::is_on_border(const Edge& edge_from_vertex) const {
  const std::uint32_t vertex = from(edge_from_vertex);
  Edge edge = edge_from_vertex;
  do {
    if (neighbour(edge) == none) return true;
    edge = edge_from(neighbour(edge), vertex);
  } while (edge.triangle != edge_from_vertex.triangle);
  return false;
}

bool TriangleLinks::can_remove(std::uint32_t triangle) const {
  int border_edges = 0, last = 0;
  for (int k = 0; k < 3; ++k)
    if (neighbour({triangle, k}) == none) ++border_edges, last = k;
  if (border_edges != 1) return border_edges > 1;
  return !is_on_border({triangle, (last + 2) % 3});
}

void TriangleLinks::remove(std::uint32_t triangle) {
  for (int k = 0; k < 3; ++k) {
    const Edge edge{triangle, k};
    relink(neighbour(edge), to(edge), none);
  }
  set(triangle, {none, none, none}, {none, none, none});
}

void TriangleLinks::set(std::uint32_t triangle, const Triangle& corners, const Triangle& links) {
  triangles_[triangle] = corners;
  links_[triangle] = links;
}

std::uint32_t TriangleLinks::add(const Triangle& corners, const Triangle& links) {
  triangles_.push_back(corners);
  links_.push_back(links);
  return std::uint32_t(triangles_.size() - 1);
}

/// The triangle's edge that leaves `from` has a new neighbour.
void TriangleLinks::relink(std::uint32_t triangle, std::uint32_t from, std::uint32_t neighbour) {
  if (triangle != none) links_[triangle][std::size_t(edge_from(triangle, from).k)] = neighbour;
}

// Below: (a, b, c) and (b, a, d) share the edge from a to b.

void TriangleLinks::turn(const Edge& edge) {
  const Edge other = twin(edge);
  const std::uint32_t t = edge.triangle, u = other.triangle;
  const std::uint32_t a = from(edge), b = to(edge), c = opposite(edge), d = opposite(other);
  const std::uint32_t bc = neighbour({t, edge.k + 1}), ca = neighbour({t, edge.k + 2});
  const std::uint32_t ad = neighbour({u, other.k + 1}), db = neighbour({u, other.k + 2});
  set(t, {c, a, d}, {ca, ad, u});
  set(u, {d, b, c}, {db, bc, t});
  relink(ad, d, t);
  relink(bc, c, u);
}

std::array<std::uint32_t, 4> TriangleLinks::split(const Edge& edge, std::uint32_t v) {
  const std::uint32_t t = edge.triangle, a = from(edge), b = to(edge), c = opposite(edge);
  const std::uint32_t bc = neighbour({t, edge.k + 1}), ca = neighbour({t, edge.k + 2});
  if (neighbour(edge) == none) {
    const std::uint32_t t2 = add({v, b, c}, {none, bc, t});
    set(t, {a, v, c}, {none, t2, ca});
    relink(bc, c, t2);
    return {t, t2, none, none};
  }
  const Edge other = twin(edge);
  const std::uint32_t u = other.triangle, d = opposite(other);
  const std::uint32_t ad = neighbour({u, other.k + 1}), db = neighbour({u, other.k + 2});
  const std::uint32_t t2 = add({v, b, c}, {u, bc, t});
  const std::uint32_t u2 = add({v, a, d}, {t, ad, u});
  set(t, {a, v, c}, {u2, t2, ca});
  set(u, {b, v, d}, {t2, u2, db});
  relink(bc, c, t2);
  relink(ad, d, u2);
  return {t, t2, u, u2};
}

}  // namespace pellucid::integrators
