// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/mesh/mesh_quality.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/surface_mesh.h"

namespace pellucid::integrators {
namespace {

constexpr double degrees = 57.295779513082320877;

struct DirectedEdge {
  std::uint32_t low, high;
  bool forward;  // runs from low to high
  std::uint32_t triangle;
};

std::vector<DirectedEdge> sorted_edges(const geometry::TriangleMesh& mesh) {
  std::vector<DirectedEdge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = mesh.triangles[i][k], b = mesh.triangles[i][(k + 1) % 3];
      edges.push_back({std::min(a, b), std::max(a, b), a < b, i});
    }
  std::sort(edges.begin(), edges.end(), [](const DirectedEdge& a, const DirectedEdge& b) {
    return a.low != b.low ? a.low < b.low : a.high < b.high;
  });
  return edges;
}

/// Which set a thing is in, when sets are joined pair by pair.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t size) : parents_(size) {
    std::iota(parents_.begin(), parents_.end(), std::size_t(0));
  }
  std::size_t find(std::size_t i) {
    while (parents_[i] != i) i = parents_[i] = parents_[parents_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) { parents_[find(a)] = find(b); }

 private:
  std::vector<std::size_t> parents_;
};

void count_edges(const geometry::TriangleMesh& mesh, MeshQuality& quality) {
  const auto edges = sorted_edges(mesh);
  DisjointSets sheets(mesh.triangles.size());
  for (std::size_t begin = 0, end; begin < edges.size(); begin = end) {
    const auto same = [&](std::size_t i) {
      return edges[i].low == edges[begin].low && edges[i].high == edges[begin].high;
    };
    for (end = begin + 1; end < edges.size() && same(end); ++end)
      sheets.join(edges[begin].triangle, edges[end].triangle);
    if (end - begin == 1) ++quality.boundary_edges;
    if (end - begin > 2) ++quality.non_manifold_edges;
    if (end - begin == 2 && edges[begin].forward == edges[begin + 1].forward)
      ++quality.misoriented_edges;
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) quality.sheets += sheets.find(i) == i;
}

void count_vertices(const geometry::TriangleMesh& mesh, MeshQuality& quality) {
  std::vector<Vec3> sorted(mesh.positions);
  const auto before = [](const Vec3& a, const Vec3& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  };
  std::sort(sorted.begin(), sorted.end(), before);
  for (std::size_t i = 1; i < sorted.size(); ++i)
    quality.duplicate_vertices += sorted[i] == sorted[i - 1];
  std::vector<bool> used(mesh.positions.size());
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t corner : triangle) used[corner] = true;
  quality.unused_vertices = std::uint64_t(std::count(used.begin(), used.end(), false));
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
    if (!(twice_area > 1e-14 * longest * longest)) ++quality.degenerate_triangles;
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
  count_edges(mesh, quality);
  count_vertices(mesh, quality);
  measure_shapes(mesh, quality);
  quality.manifold = geometry::surface_mesh(mesh).has_value();
  return quality;
}

}  // namespace pellucid::integrators
