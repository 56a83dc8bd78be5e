// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>
#include <optional>
#include <queue>
#include <utility>

#include "geometry/half_edges.h"
#include "geometry/heat_distances.h"
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

/// What is around a vertex. Patches go on where triangles have a vertex in common, even where they
/// are no manifold, so that a vertex has its copies' triangles, too.
class Neighbourhoods {
 public:
  explicit Neighbourhoods(const Surface& surface)
      : half_edges_(geometry::half_edges(surface.positions, surface.triangles)),
        given_(surface.positions.size()),
        next_copy_(half_edges_.mesh.n_vertices(), none) {
    for (auto i = std::uint32_t(given_); i < next_copy_.size(); ++i)
      next_copy_[i] = std::exchange(next_copy_[given(i)], i);
  }

  /// Calls use(triangle) for each triangle of a vertex.
  template <class Use>
  void for_each_triangle(std::uint32_t vertex, const Use& use) const {
    for_each_half_edge(vertex, [&](OpenMesh::HalfedgeHandle h) {
      if (const auto face = half_edges_.mesh.face_handle(h); face.is_valid())
        use(std::uint32_t(face.idx()));
    });
  }

  /// Calls use(vertex) for the other end of each edge of a vertex.
  template <class Use>
  void for_each_neighbour(std::uint32_t vertex, const Use& use) const {
    for_each_half_edge(vertex, [&](OpenMesh::HalfedgeHandle h) {
      use(given(std::uint32_t(half_edges_.mesh.to_vertex_handle(h).idx())));
    });
  }

 private:
  std::uint32_t given(std::uint32_t i) const {
    return i < given_ ? i : half_edges_.copied[i - given_];
  }

  /// Calls use(half-edge) for all that leave a vertex.
  template <class Use>
  void for_each_half_edge(std::uint32_t vertex, const Use& use) const {
    const geometry::SurfaceMesh& mesh = half_edges_.mesh;
    for (std::uint32_t v = vertex; v != none; v = next_copy_[v]) {
      const auto first = mesh.halfedge_handle(OpenMesh::VertexHandle(int(v)));
      if (!first.is_valid()) continue;
      auto h = first;
      do {
        use(h);
        h = mesh.next_halfedge_handle(mesh.opposite_halfedge_handle(h));
      } while (h != first);
    }
  }

  geometry::HalfEdges half_edges_;
  std::size_t given_;
  std::vector<std::uint32_t> next_copy_;  // of the same given vertex
};

/// Distances along edges from the middles of triangles.
class EdgeDistances {
 public:
  EdgeDistances(const Surface& surface, const Neighbourhoods& around)
      : surface_(surface), around_(around) {}

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
      const Vec3& x = surface_.positions[vertex];
      around_.for_each_neighbour(vertex, [&, from = distance](std::uint32_t other) {
        offer(other, from + glm::length(surface_.positions[other] - x), accept);
      });
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
  const Neighbourhoods& around_;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> queue_;
};

/// The Voronoi cells of the vertices about triangles that are far from each other.
class Cells {
 public:
  Cells(const Surface& surface, std::size_t count, SurfaceDistance distance)
      : surface_(surface),
        around_(surface),
        along_edges_(surface, around_),
        cell_(surface.positions.size(), none),
        distance_(surface.positions.size(), infinite),
        seed_cell_(surface.triangles.size(), none) {
    if (distance == SurfaceDistance::heat) heat_.emplace(surface.positions, surface.triangles);
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
    spread(triangle, [&](std::uint32_t vertex, double distance) {
      if (!(distance < distance_[vertex])) return false;
      distance_[vertex] = distance;
      cell_[vertex] = cell;
      return true;
    });
  }

  /// As EdgeDistances::spread().
  template <class Accept>
  void spread(std::uint32_t triangle, const Accept& accept) {
    if (!heat_) return along_edges_.spread(triangle, accept);
    for (const auto& [vertex, distance] : heat_->from(triangle)) accept(vertex, distance);
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
    bool seeded = false;
    std::uint32_t first = none;
    around_.for_each_triangle(vertex, [&](std::uint32_t t) {
      seeded = seeded || seed_cell_[t] != none;
      first = std::min(first, t);
    });
    if (!seeded) seed(first);
    return !seeded;
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
  Neighbourhoods around_;
  EdgeDistances along_edges_;
  std::optional<geometry::HeatDistances> heat_;
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
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
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
    spread(seeds_[cell], [&](std::uint32_t vertex, double d) {
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

Elements surface_elements(const Scene& scene, std::size_t patches, SurfaceDistance distance) {
  const Surface surface = gather(scene);
  return Cells(surface, patches, distance).elements();
}

}  // namespace pellucid::scene
