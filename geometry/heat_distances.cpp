// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/heat_distances.h"

#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/error.h"
#include "geometry/half_edges.h"

namespace pellucid::geometry {
namespace {

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Heat =
    CGAL::Heat_method_3::Surface_mesh_geodesic_distances_3<Mesh,
                                                           CGAL::Heat_method_3::Intrinsic_Delaunay>;

constexpr std::uint32_t none = ~0u;

/// Triangles that hang together by edges, their vertices numbered anew.
struct Piece {
  Mesh mesh;
  std::vector<std::uint32_t> vertices;  // of the half-edge mesh
  std::vector<std::uint32_t> triangles;
  std::optional<Heat> heat;
  Mesh::Property_map<Mesh::Vertex_index, double> distances;
};

/// Which piece each triangle is of.
std::vector<std::uint32_t> number_pieces(const SurfaceMesh& mesh, std::uint32_t& count) {
  std::vector<std::uint32_t> pieces(mesh.n_faces(), none);
  std::vector<OpenMesh::FaceHandle> open;
  count = 0;
  for (const auto first : mesh.faces()) {
    if (pieces[std::size_t(first.idx())] != none) continue;
    pieces[std::size_t(first.idx())] = count;
    open.assign(1, first);
    while (!open.empty()) {
      const auto face = open.back();
      open.pop_back();
      for (const auto next : mesh.ff_range(face)) {
        std::uint32_t& piece = pieces[std::size_t(next.idx())];
        if (piece != none) continue;
        piece = count;
        open.push_back(next);
      }
    }
    ++count;
  }
  return pieces;
}

}  // namespace

struct HeatDistances::State {
  State(std::span<const Vec3> positions, std::span<const Corners> triangles)
      : given(positions.size()), half_edges(geometry::half_edges(positions, triangles)) {
    for (std::size_t i = 0; i < triangles.size(); ++i) check_area(positions, triangles[i], i);
    std::uint32_t count = 0;
    piece_of = number_pieces(half_edges.mesh, count);
    pieces.resize(count);
    local.assign(half_edges.mesh.n_vertices(), none);
    for (std::uint32_t t = 0; t < triangles.size(); ++t) pieces[piece_of[t]].triangles.push_back(t);
  }

  static void check_area(std::span<const Vec3> positions, const Corners& corners, std::size_t i) {
    const Vec3& a = positions[corners[0]];
    const Vec3 normal = glm::cross(positions[corners[1]] - a, positions[corners[2]] - a);
    if (!(glm::length(normal) > 0))
      throw InputError(fmt::format(
          "triangle {} has no area, and no heat flows through it; accepted: distances=edges", i));
  }

  std::array<std::uint32_t, 3> corners_of(std::uint32_t triangle) const {
    std::array<std::uint32_t, 3> corners{};
    auto corner = corners.begin();
    for (const auto v : half_edges.mesh.fv_range(OpenMesh::FaceHandle(int(triangle))))
      *corner++ = std::uint32_t(v.idx());
    return corners;
  }
  Vec3 position(std::uint32_t vertex) const {
    const auto& x = half_edges.mesh.point(OpenMesh::VertexHandle(int(vertex)));
    return Vec3(x[0], x[1], x[2]);
  }
  std::uint32_t given_of(std::uint32_t vertex) const {
    return vertex < given ? vertex : half_edges.copied[vertex - given];
  }

  /// Makes the piece's mesh and factorizes its matrices, once.
  Piece& piece(std::uint32_t triangle) {
    Piece& piece = pieces[piece_of[triangle]];
    if (piece.heat) return piece;
    for (const std::uint32_t t : piece.triangles) {
      std::array<Mesh::Vertex_index, 3> corners;
      std::ranges::transform(corners_of(t), corners.begin(), [&](std::uint32_t vertex) {
        if (local[vertex] == none) {
          const Vec3 x = position(vertex);
          local[vertex] = std::uint32_t(piece.mesh.add_vertex({x.x, x.y, x.z}));
          piece.vertices.push_back(vertex);
        }
        return Mesh::Vertex_index(local[vertex]);
      });
      piece.mesh.add_face(corners[0], corners[1], corners[2]);
    }
    piece.distances =
        piece.mesh.add_property_map<Mesh::Vertex_index, double>("v:distance", 0).first;
    if (piece.triangles.size() > 1) piece.heat.emplace(piece.mesh);
    return piece;
  }

  std::size_t given;
  HalfEdges half_edges;
  std::vector<std::uint32_t> piece_of;  // of each triangle
  std::vector<Piece> pieces;
  std::vector<std::uint32_t> local;  // of each vertex of the half-edge mesh, in its piece
};

HeatDistances::HeatDistances(std::span<const Vec3> positions, std::span<const Corners> triangles)
    : state_(std::make_unique<State>(positions, triangles)) {}

HeatDistances::~HeatDistances() = default;

std::vector<HeatDistances::Reached> HeatDistances::from(std::uint32_t triangle) {
  const auto corners = state_->corners_of(triangle);
  Vec3 middle(0);
  for (const std::uint32_t corner : corners) middle += state_->position(corner) / 3.0;
  const auto straight = [&](std::uint32_t vertex) {
    return glm::distance(state_->position(vertex), middle);
  };
  std::vector<Reached> reached;
  for (const std::uint32_t corner : corners)
    reached.push_back({state_->given_of(corner), straight(corner)});
  Piece& piece = state_->piece(triangle);
  if (!piece.heat) return reached;
  double rest = 0;
  for (const std::uint32_t corner : corners) {
    piece.heat->add_source(Mesh::Vertex_index(state_->local[corner]));
    rest += straight(corner) / 3;
  }
  piece.heat->estimate_geodesic_distances(piece.distances);
  piece.heat->clear_sources();
  for (std::uint32_t i = 0; i < piece.vertices.size(); ++i) {
    const std::uint32_t vertex = piece.vertices[i];
    if (std::ranges::find(corners, vertex) != corners.end()) continue;
    reached.push_back({state_->given_of(vertex), piece.distances[Mesh::Vertex_index(i)] + rest});
  }
  return reached;
}

}  // namespace pellucid::geometry
