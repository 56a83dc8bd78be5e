// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Triangles of known surfaces, and what holds of every half-edge mesh.

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "geometry/half_edges.h"

namespace pellucid::geometry::testing {

using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;
using Triangles = std::vector<Corners>;

inline HalfEdges join(std::size_t vertices, const Triangles& triangles) {
  std::vector<Vec3> positions;
  for (std::size_t i = 0; i < vertices; ++i) positions.emplace_back(i, i * i, 0);
  return half_edges(positions, triangles);
}

/// columns x rows squares, cut in two. Around a direction that closes, the last column or row of
/// vertices is the first one.
inline Triangles grid(std::uint32_t columns, std::uint32_t rows, bool ring, bool torus) {
  const std::uint32_t across = ring ? columns : columns + 1, up = torus ? rows : rows + 1;
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return j % up * across + i % across; };
  Triangles triangles;
  for (std::uint32_t j = 0; j < rows; ++j)
    for (std::uint32_t i = 0; i < columns; ++i) {
      triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return triangles;
}

inline std::size_t border_loops(const SurfaceMesh& mesh) {
  std::vector<bool> visited(mesh.n_halfedges());
  std::size_t loops = 0;
  for (const HalfedgeHandle start : mesh.halfedges()) {
    if (!mesh.is_boundary(start) || visited[std::size_t(start.idx())]) continue;
    ++loops;
    for (auto h = start; !visited[std::size_t(h.idx())]; h = mesh.next_halfedge_handle(h))
      visited[std::size_t(h.idx())] = true;
  }
  return loops;
}

inline int euler_characteristic(const SurfaceMesh& mesh) {
  return int(mesh.n_vertices()) - int(mesh.n_edges()) + int(mesh.n_faces());
}

/// What holds of every half-edge mesh.
inline void expect_sound(const SurfaceMesh& mesh) {
  std::vector<int> arrivals(mesh.n_halfedges());
  for (const HalfedgeHandle h : mesh.halfedges()) {
    const HalfedgeHandle next = mesh.next_halfedge_handle(h);
    ASSERT_TRUE(next.is_valid());
    ++arrivals[std::size_t(next.idx())];
    EXPECT_EQ(mesh.from_vertex_handle(next), mesh.to_vertex_handle(h));
    EXPECT_EQ(mesh.face_handle(next), mesh.face_handle(h));
    if (!mesh.is_boundary(h)) {
      EXPECT_EQ(mesh.next_halfedge_handle(mesh.next_halfedge_handle(next)), h);
    }
  }
  EXPECT_EQ(std::ranges::count(arrivals, 1), std::ptrdiff_t(arrivals.size()));
  std::vector<std::size_t> leaving(mesh.n_vertices()), borders(mesh.n_vertices());
  for (const HalfedgeHandle h : mesh.halfedges()) {
    ++leaving[std::size_t(mesh.from_vertex_handle(h).idx())];
    borders[std::size_t(mesh.from_vertex_handle(h).idx())] += mesh.is_boundary(h);
  }
  for (const VertexHandle v : mesh.vertices()) {
    EXPECT_EQ(mesh.valence(v), leaving[std::size_t(v.idx())]);  // all of them in one fan
    EXPECT_LE(borders[std::size_t(v.idx())], 1u);
    if (mesh.is_isolated(v)) continue;
    EXPECT_EQ(mesh.from_vertex_handle(mesh.halfedge_handle(v)), v);
    EXPECT_EQ(mesh.is_boundary(mesh.halfedge_handle(v)), borders[std::size_t(v.idx())] > 0);
  }
}

}  // namespace pellucid::geometry::testing
