// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A heavy header, by OpenMesh: include it in .cpp files alone.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/surface_mesh.h"
#include "geometry/triangle_mesh.h"

namespace pellucid::geometry {

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

/// Joins triangles, whose corners are below the number of positions, in time linear in both. Throws
/// InputError for more than the 357 million whose half-edges an int can count.
HalfEdges half_edges(std::span<const Vec3> positions, std::span<const Corners> triangles);
/// Joins the triangles of a mesh; throws as above.
HalfEdges half_edges(const TriangleMesh& mesh);

}  // namespace pellucid::geometry
