// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/mesh/mesh_quality.h"

#include <algorithm>
#include <cmath>

#include "geometry/half_edges.h"
#include "integrators/mesh/disjoint_sets.h"
#include "integrators/mesh/facet_normal.h"

namespace pellucid::integrators {
namespace {

constexpr double degrees = 57.295779513082320877;

/// Triangles that share an edge are of one sheet, joined there or not.
std::uint64_t count_sheets(const geometry::HalfEdges& half_edges) {
  const geometry::SurfaceMesh& mesh = half_edges.mesh;
  DisjointSets sheets(mesh.n_faces());
  for (const auto edge : mesh.edges())
    if (!mesh.is_boundary(edge))
      sheets.join(std::size_t(mesh.face_handle(mesh.halfedge_handle(edge, 0)).idx()),
                  std::size_t(mesh.face_handle(mesh.halfedge_handle(edge, 1)).idx()));
  for (const auto& [one, other] : half_edges.apart) sheets.join(one, other);
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < mesh.n_faces(); ++i) count += sheets.find(i) == i;
  return count;
}

/// Triangles that share a vertex are of one sheet: fewer than by edges where bow-ties join them.
std::uint64_t count_sheets_by_vertices(const geometry::TriangleMesh& mesh) {
  DisjointSets sheets(mesh.positions.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    sheets.join(a, b);
    sheets.join(a, c);
  }
  std::vector<bool> has_triangles(mesh.positions.size());
  for (const auto& corners : mesh.triangles) has_triangles[sheets.find(corners[0])] = true;
  return std::uint64_t(std::count(has_triangles.begin(), has_triangles.end(), true));
}

void measure_connectivity(const geometry::TriangleMesh& mesh, MeshQuality& quality) {
  const geometry::HalfEdges half_edges = geometry::half_edges(mesh);
  quality.boundary_edges = half_edges.boundary_edges;
  quality.non_manifold_edges = half_edges.non_manifold_edges;
  quality.misoriented_edges = half_edges.misoriented_edges;
  quality.non_manifold_vertices = half_edges.non_manifold_vertices;
  quality.manifold = half_edges.is_manifold();
  quality.sheets = count_sheets(half_edges);
  quality.sheets_by_vertices = count_sheets_by_vertices(mesh);
  for (const auto vertex : half_edges.mesh.vertices())
    quality.unused_vertices += half_edges.mesh.is_isolated(vertex);
}

void count_duplicates(const geometry::TriangleMesh& mesh, MeshQuality& quality) {
  std::vector<Vec3> sorted(mesh.positions);
  const auto before = [](const Vec3& a, const Vec3& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  };
  std::sort(sorted.begin(), sorted.end(), before);
  for (std::size_t i = 1; i < sorted.size(); ++i)
    quality.duplicate_vertices += sorted[i] == sorted[i - 1];
}

Percentiles percentiles(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const auto at = [&](double part) {
    return values[std::size_t(part * double(values.size() - 1))];
  };
  return {at(0.01), at(0.5), at(0.99), values.back()};
}

double angle(const Vec3& a, const Vec3& b) {
  return degrees * std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

void measure_shapes(const geometry::TriangleMesh& mesh, MeshQuality& quality) {
  std::vector<double> angles, aspects, normals;
  for (const auto& corners : mesh.triangles) {
    const Vec3 x[] = {mesh.positions[corners[0]], mesh.positions[corners[1]],
                      mesh.positions[corners[2]]};
    const Vec3 area = glm::cross(x[1] - x[0], x[2] - x[0]);
    double smallest = 180, longest = 0;
    for (int k = 0; k < 3; ++k) {
      smallest = std::min(smallest, angle(x[(k + 1) % 3] - x[k], x[(k + 2) % 3] - x[k]));
      longest = std::max(longest, glm::distance(x[k], x[(k + 1) % 3]));
    }
    const double twice_area = glm::length(area);
    if (!has_area(x[0], x[1], x[2])) ++quality.degenerate_triangles;
    angles.push_back(smallest);
    aspects.push_back(std::sqrt(0.75) * longest * longest / twice_area);
    if (!mesh.normals.empty())
      for (const std::uint32_t corner : corners)
        normals.push_back(angle(area, mesh.normals[corner]));
  }
  quality.min_angle = percentiles(std::move(angles));
  quality.aspect = percentiles(std::move(aspects));
  quality.normal_degrees = percentiles(std::move(normals));
}

}  // namespace

MeshQuality measure_quality(const geometry::TriangleMesh& mesh) {
  MeshQuality quality;
  measure_connectivity(mesh, quality);
  count_duplicates(mesh, quality);
  measure_shapes(mesh, quality);
  return quality;
}

}  // namespace pellucid::integrators
