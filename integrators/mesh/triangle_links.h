// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace pellucid::integrators {

/// The triangles of an oriented manifold with their neighbours, for edits that keep it one.
class TriangleLinks {
 public:
  using Triangle = std::array<std::uint32_t, 3>;
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  /// Edge k of a triangle runs from its corner k to the next one.
  struct Edge {
    std::uint32_t triangle;
    int k;
  };

  /// `triangles` is edited in place and must outlive this.
  TriangleLinks(std::vector<Triangle>& triangles, std::size_t vertex_count);

  const Triangle& corners(std::uint32_t triangle) const { return triangles_[triangle]; }
  std::uint32_t from(const Edge& edge) const { return corner(edge.triangle, edge.k); }
  std::uint32_t to(const Edge& edge) const { return corner(edge.triangle, edge.k + 1); }
  std::uint32_t opposite(const Edge& edge) const { return corner(edge.triangle, edge.k + 2); }
  std::uint32_t neighbour(const Edge& edge) const { return links_[edge.triangle][edge.k % 3]; }
  /// The same edge as its neighbour has it; there must be one.
  Edge twin(const Edge& edge) const;

  /// May the edge be turned? Not on the border, nor where the other diagonal is an edge already.
  bool can_turn(const Edge& edge) const;
  /// Replaces the edge by the other diagonal of its two triangles, which keep their numbers.
  void turn(const Edge& edge);
  /// Puts a vertex on the edge. Returns the numbers of the triangles around it, none where the edge
  /// is on the border.
  std::array<std::uint32_t, 4> split(const Edge& edge, std::uint32_t vertex);
  /// May a triangle on the border go? Not where two parts would then meet in a vertex alone.
  bool can_remove(std::uint32_t triangle) const;
  /// Takes it out: its corners become none.
  void remove(std::uint32_t triangle);
  bool is_removed(std::uint32_t triangle) const { return triangles_[triangle][0] == none; }

 private:
  std::uint32_t corner(std::uint32_t triangle, int k) const { return triangles_[triangle][k % 3]; }
  Edge edge_from(std::uint32_t triangle, std::uint32_t vertex) const;
  bool is_on_border(const Edge& edge_from_vertex) const;
  bool are_joined(const Edge& edge_from_a, std::uint32_t b) const;
  void set(std::uint32_t triangle, const Triangle& corners, const Triangle& links);
  void relink(std::uint32_t triangle, std::uint32_t from, std::uint32_t neighbour);
  std::uint32_t add(const Triangle& corners, const Triangle& links);

  std::vector<Triangle>& triangles_;
  std::vector<Triangle> links_;  // by edge: the triangle on its other side
};

}  // namespace pellucid::integrators
