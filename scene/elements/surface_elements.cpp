// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>
#include <queue>

#include "scene/elements/elements.h"

namespace pellucid::scene {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr std::uint32_t none = ~0u;

/// The triangles of all transparent meshes as one; vertices are numbered over all meshes.
struct Surface {
  std::vector<Vec3> positions;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> of_scene;  // number of each among the triangles of all meshes
  std::size_t scene_triangles = 0;
};

Surface gather(const Scene& scene) {
  Surface surface;
  for (const SceneObject& object : scene.objects) {
    const auto* mesh = std::get_if<geometry::TriangleMesh>(&object.shape);
    if (!mesh) continue;
    const auto base = std::uint32_t(surface.positions.size());
    surface.positions.insert(surface.positions.end(), mesh->positions.begin(),
                             mesh->positions.end());
    for (const auto& [a, b, c] : mesh->triangles) {
      const auto number = std::uint32_t(surface.scene_triangles++);
      if (object.opaque) continue;
      surface.triangles.push_back({base + a, base + b, base + c});
      surface.of_scene.push_back(number);
    }
  }
  return surface;
}

/// The triangles of each vertex.
Rows triangles_by_vertex(const Surface& surface) {
  Rows rows;
  rows.offsets.assign(surface.positions.size() + 1, 0);
  for (const auto& triangle : surface.triangles)
    for (const std::uint32_t corner : triangle) ++rows.offsets[corner + 1];
  for (std::size_t i = 1; i < rows.offsets.size(); ++i) rows.offsets[i] += rows.offsets[i - 1];
  rows.values.resize(rows.offsets.back());
  std::vector<std::uint64_t> next(rows.offsets.begin(), rows.offsets.end() - 1);
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t)
    for (const std::uint32_t corner : surface.triangles[t]) rows.values[next[corner]++] = t;
  return rows;
}

/// Distances along edges from the middles of triangles.
class EdgeDistances {
 public:
  EdgeDistances(const Surface& surface, const Rows& triangles_of)
      : surface_(surface), triangles_of_(triangles_of) {}

  /// Asks accept(vertex, distance) whether a vertex is reached, and goes on from those that are. A
  /// vertex is offered again where there is a shorter way.
  template <class Accept>
  void spread(std::uint32_t triangle, const Accept& accept) {
    const auto& corners = surface_.triangles[triangle];
    for (const std::uint32_t corner : corners)
      offer(corner, glm::length(surface_.positions[corner] - middle(triangle)), accept);
    while (!queue_.empty()) {
      const auto [distance, vertex] = queue_.top();
      queue_.pop();
      for (const std::uint32_t t : triangles_of_[vertex])
        for (const std::uint32_t other : surface_.triangles[t])
          if (other != vertex)
            offer(other,
                  distance + glm::length(surface_.positions[other] - surface_.positions[vertex]),
                  accept);
    }
  }

 private:
  using Reached = std::pair<double, std::uint32_t>;

  template <class Accept>
  void offer(std::uint32_t vertex, double distance, const Accept& accept) {
    if (accept(vertex, distance)) queue_.emplace(distance, vertex);
  }

  Vec3 middle(std::uint32_t triangle) const {
    const auto& [a, b, c] = surface_.triangles[triangle];
    return (surface_.positions[a] + surface_.positions[b] + surface_.positions[c]) / 3.0;
  }

  const Surface& surface_;
  const Rows& triangles_of_;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> queue_;
};

/// The Voronoi cells of the vertices about triangles that are far from each other.
class Cells {
 public:
  Cells(const Surface& surface, std::size_t count)
      : surface_(surface),
        triangles_of_(triangles_by_vertex(surface)),
        distances_(surface, triangles_of_),
        cell_(surface.positions.size(), none),
        distance_(surface.positions.size(), infinite),
        seed_cell_(surface.triangles.size(), none) {
    seed_components();
    while (seeds_.size() < count && seed_farthest()) {
    }
  }

  Elements elements();

 private:
  void seed(std::uint32_t triangle) {
    const auto cell = std::uint32_t(seeds_.size());
    seeds_.push_back(triangle);
    seed_cell_[triangle] = cell;
    distances_.spread(triangle, [&](std::uint32_t vertex, double distance) {
      if (!(distance < distance_[vertex])) return false;
      distance_[vertex] = distance;
      cell_[vertex] = cell;
      return true;
    });
  }

  void seed_components() {
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t)
      if (cell_[surface_.triangles[t][0]] == none) seed(t);
  }

  /// Of the vertices of triangles; 0 where there is none.
  double farthest(std::size_t& vertex) const {
    double largest = 0;
    for (std::size_t v = 0; v < distance_.size(); ++v)
      if (cell_[v] != none && distance_[v] > largest) {
        largest = distance_[v];
        vertex = v;
      }
    return largest;
  }

  /// False when no vertex is far from all seeds but those of their own triangles.
  bool seed_farthest() {
    std::size_t vertex = 0;
    if (farthest(vertex) == 0) return false;
    for (const std::uint32_t t : triangles_of_[vertex])
      if (seed_cell_[t] != none) return false;
    seed(triangles_of_[vertex][0]);
    return true;
  }

  std::uint32_t cell_of_triangle(std::uint32_t t) const {
    if (seed_cell_[t] != none) return seed_cell_[t];
    const auto& corners = surface_.triangles[t];
    return cell_[*std::ranges::min_element(
        corners, {}, [&](std::uint32_t corner) { return distance_[corner]; })];
  }

  Rows neighbours() const;
  void mix_vertices(Elements& elements);

  const Surface& surface_;
  Rows triangles_of_;
  EdgeDistances distances_;
  std::vector<std::uint32_t> cell_;       // of each vertex, the nearest seed's
  std::vector<double> distance_;          // from it
  std::vector<std::uint32_t> seeds_;      // triangles
  std::vector<std::uint32_t> seed_cell_;  // of each triangle that is one
};

/// Cells that share a triangle or have one at each other.
Rows Cells::neighbours() const {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t)
    for (const std::uint32_t corner : surface_.triangles[t]) {
      const std::uint32_t a = cell_of_triangle(t), b = cell_[corner];
      if (a == b) continue;
      pairs.emplace_back(a, b);
      pairs.emplace_back(b, a);
    }
  std::ranges::sort(pairs);
  pairs.erase(std::ranges::unique(pairs).begin(), pairs.end());
  Rows rows;
  auto pair = pairs.begin();
  for (std::uint32_t cell = 0; cell < seeds_.size(); ++cell) {
    for (; pair != pairs.end() && pair->first == cell; ++pair) rows.values.push_back(pair->second);
    rows.end_row();
  }
  return rows;
}

void Cells::mix_vertices(Elements& elements) {
  std::size_t unused = 0;
  const double covered = farthest(unused);
  const double reach = covered > 0 ? 2 * covered : 1;  // all vertices at one place: any will do
  std::vector<std::vector<std::pair<std::uint32_t, float>>> shares(surface_.positions.size());
  std::vector<double> distance(surface_.positions.size(), infinite);
  std::vector<std::uint32_t> reached;
  for (std::uint32_t cell = 0; cell < seeds_.size(); ++cell) {
    reached.clear();
    distances_.spread(seeds_[cell], [&](std::uint32_t vertex, double d) {
      if (!(d < reach && d < distance[vertex])) return false;
      if (distance[vertex] == infinite) reached.push_back(vertex);
      distance[vertex] = d;
      return true;
    });
    for (const std::uint32_t vertex : reached) {
      const double d = std::max(distance[vertex], 1e-6 * reach) / reach;
      shares[vertex].emplace_back(cell, float((1 / d - 1) * (1 / d - 1)));
      distance[vertex] = infinite;
    }
  }
  for (const auto& of_vertex : shares) {
    double sum = 0;
    for (const auto& [cell, share] : of_vertex) sum += share;
    for (const auto& [cell, share] : of_vertex) {
      elements.of_vertex.values.push_back(cell);
      elements.weights.push_back(float(share / sum));
    }
    elements.of_vertex.end_row();
  }
}

Elements Cells::elements() {
  Elements result;
  result.of_primitive.assign(surface_.scene_triangles, 0);
  for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t)
    result.of_primitive[surface_.of_scene[t]] = cell_of_triangle(t);
  result.neighbours = neighbours();
  mix_vertices(result);
  return result;
}

}  // namespace

Elements surface_elements(const Scene& scene, std::size_t patches) {
  const Surface surface = gather(scene);
  return Cells(surface, patches).elements();
}

}  // namespace pellucid::scene
