// SPDX-License-Identifier: GPL-3.0-or-later
// Half-edge meshes against the topology of known surfaces and against a search of all pairs.

#include "geometry/half_edges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <random>
#include <set>

#include "tests/geometry/half_edge_checks.h"

namespace pellucid::geometry {
namespace {

using namespace testing;

void expect_surface(const HalfEdges& joined, const Triangles& triangles, int characteristic,
                    std::size_t loops) {
  expect_sound(joined.mesh);
  EXPECT_TRUE(joined.is_manifold());
  EXPECT_EQ(euler_characteristic(joined.mesh), characteristic);
  EXPECT_EQ(border_loops(joined.mesh), loops);
  EXPECT_EQ(triangle_mesh(joined.mesh).triangles, triangles);
}

TEST(UnitHalfEdges, KnownSurfacesHaveTheirEulerCharacteristics) {
  const Triangles disc = grid(5, 4, false, false);
  expect_surface(join(30, disc), disc, 1, 1);
  EXPECT_EQ(join(30, disc).boundary_edges, 18u);
  const Triangles annulus = grid(5, 4, true, false);
  expect_surface(join(25, annulus), annulus, 0, 2);
  const Triangles torus = grid(5, 4, true, true);
  expect_surface(join(20, torus), torus, 0, 0);
  const Triangles octahedron = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  expect_surface(join(6, octahedron), octahedron, 2, 0);
  expect_surface(join(0, {}), {}, 0, 0);
}

TEST(UnitHalfEdges, PositionsAreThoseGiven) {
  TriangleMesh given;
  given.positions = {{1, 2, 3}, {4, 5, 6}, {7, 8, 10}};
  given.triangles = {{2, 0, 1}};
  const TriangleMesh taken = triangle_mesh(half_edges(given).mesh);
  EXPECT_EQ(taken.positions, given.positions);
  EXPECT_EQ(taken.triangles, given.triangles);
}

TEST(UnitHalfEdges, AMobiusStripIsCutWhereItsOrientationBreaks) {
  constexpr std::uint32_t n = 6;
  const auto at = [](std::uint32_t i, std::uint32_t j) {
    return i < n ? 2 * i + j : 1 - j;  // once around, up is down
  };
  Triangles strip;
  for (std::uint32_t i = 0; i < n; ++i) {
    strip.push_back({at(i, 0), at(i + 1, 0), at(i + 1, 1)});
    strip.push_back({at(i, 0), at(i + 1, 1), at(i, 1)});
  }
  const HalfEdges joined = join(2 * n, strip);
  expect_sound(joined.mesh);
  EXPECT_EQ(joined.misoriented_edges, 1u);
  EXPECT_EQ(joined.non_manifold_edges, 0u);
  EXPECT_EQ(joined.copied.size(), 2u);  // the cut's ends
  EXPECT_EQ(euler_characteristic(joined.mesh), 1);
  EXPECT_EQ(border_loops(joined.mesh), 1u);
  EXPECT_FALSE(joined.is_manifold());
}

TEST(UnitHalfEdges, PagesOfABookStayApart) {
  const HalfEdges joined = join(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  expect_sound(joined.mesh);
  EXPECT_EQ(joined.non_manifold_edges, 1u);
  EXPECT_EQ(joined.boundary_edges, 6u);
  EXPECT_EQ(joined.apart.size(), 2u);
  EXPECT_EQ(joined.non_manifold_vertices, 2u);
  EXPECT_EQ(joined.copied, (std::vector<std::uint32_t>{1, 0, 0, 1}));
  EXPECT_EQ(border_loops(joined.mesh), 3u);
  EXPECT_EQ(corners(joined.mesh, FaceHandle(0)), (Corners{0, 1, 2}));
}

TEST(UnitHalfEdges, FansThatMeetInAVertexAreSplit) {
  // Two tetrahedra: both fans about vertex 0 are closed.
  const HalfEdges joined = join(
      7, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}, {0, 4, 5}, {0, 5, 6}, {0, 6, 4}, {4, 6, 5}});
  expect_sound(joined.mesh);
  EXPECT_EQ(euler_characteristic(joined.mesh), 4);
  EXPECT_EQ(joined.copied, std::vector<std::uint32_t>{0});
  EXPECT_EQ(corners(joined.mesh, FaceHandle(4)), (Corners{7, 4, 5}));
  EXPECT_FALSE(joined.is_manifold());
}

TEST(UnitHalfEdges, ATriangleThatRepeatsAVertexStaysApart) {
  const HalfEdges joined = join(4, {{0, 1, 2}, {2, 1, 1}, {1, 3, 2}});
  expect_sound(joined.mesh);
  EXPECT_EQ(joined.folded_triangles, 1u);
  EXPECT_EQ(joined.boundary_edges, 7u);
  EXPECT_EQ(border_loops(joined.mesh), 2u);
  EXPECT_EQ(joined.copied, (std::vector<std::uint32_t>{2, 1, 1}));
  EXPECT_FALSE(joined.is_manifold());
}

/// The same by a search of all pairs.
class Soup {
 public:
  explicit Soup(const Triangles& triangles) : triangles_(triangles) {}

  /// The side that is joined to this one; sides are numbered as in the mesh's source.
  std::optional<std::size_t> partner(std::size_t side) const {
    std::vector<std::size_t> others;
    for (std::size_t i = 0; i < 3 * triangles_.size(); ++i)
      if (i != side && same_edge(i, side)) others.push_back(i);
    const bool joined = others.size() == 1 && from(others[0]) == to(side);
    return joined ? std::optional(others[0]) : std::nullopt;
  }

  /// For each corner, the first one in the same fan.
  std::vector<std::size_t> fans() const {
    std::vector<std::size_t> fan(3 * triangles_.size());
    for (std::size_t i = 0; i < fan.size(); ++i) fan[i] = i;
    const auto unite = [&](std::size_t a, std::size_t b) {
      const std::size_t low = std::min(fan[a], fan[b]), high = std::max(fan[a], fan[b]);
      std::ranges::replace(fan, high, low);
    };
    for (std::size_t i = 0; i < fan.size(); ++i)
      if (const auto other = partner(i)) unite(i, next(*other));
    return fan;
  }

  std::uint32_t from(std::size_t side) const { return triangles_[side / 3][side % 3]; }

 private:
  static std::size_t next(std::size_t side) { return side % 3 == 2 ? side - 2 : side + 1; }
  std::uint32_t to(std::size_t side) const { return from(next(side)); }
  std::set<std::uint32_t> edge(std::size_t side) const { return {from(side), to(side)}; }
  bool is_folded(std::size_t side) const {
    const Corners& t = triangles_[side / 3];
    return std::set(t.begin(), t.end()).size() < 3;
  }
  bool same_edge(std::size_t a, std::size_t b) const {
    return !is_folded(a) && !is_folded(b) && edge(a) == edge(b);
  }

  const Triangles& triangles_;
};

/// Twins, folded triangles, edges of many triangles and vertices of none are all among them.
Triangles random_soup(std::mt19937& random, std::uint32_t vertices) {
  Triangles triangles = grid(3, 3, random() % 2, random() % 2);
  for (Corners& triangle : triangles)
    if (random() % 8 == 0) std::swap(triangle[0], triangle[1]);
  for (std::uint32_t i = random() % 24; i > 0; --i)
    triangles.push_back({std::uint32_t(random() % vertices), std::uint32_t(random() % vertices),
                         std::uint32_t(random() % vertices)});
  if (random() % 2) triangles.push_back(triangles[random() % triangles.size()]);
  std::ranges::shuffle(triangles, random);
  return triangles;
}

void expect_as_searched(const HalfEdges& joined, const Triangles& triangles,
                        std::uint32_t vertices) {
  const Soup soup(triangles);
  const std::vector<std::size_t> fans = soup.fans();
  std::vector<std::uint32_t> vertex_of_fan(fans.size());
  std::vector<bool> kept(vertices);
  std::set<std::uint32_t> split;
  std::uint32_t copies = 0;
  for (std::size_t side = 0; side < fans.size(); ++side) {
    const auto h = sides(joined.mesh, FaceHandle(int(side / 3)))[side % 3];
    const auto beyond = joined.mesh.opposite_halfedge_handle(h);
    const auto partner = soup.partner(side);
    ASSERT_EQ(joined.mesh.face_handle(h), FaceHandle(int(side / 3)));
    ASSERT_EQ(joined.mesh.face_handle(beyond).idx(), partner ? int(*partner / 3) : -1);
    if (fans[side] == side) {  // a new fan: has the vertex if it is free, else the next copy
      const std::uint32_t v = soup.from(side);
      if (kept[v]) split.insert(v);
      vertex_of_fan[side] = kept[v] ? vertices + copies++ : v;
      kept[v] = true;
    }
    ASSERT_EQ(joined.mesh.from_vertex_handle(h).idx(), int(vertex_of_fan[fans[side]]));
  }
  EXPECT_EQ(joined.copied.size(), copies);
  EXPECT_EQ(joined.mesh.n_vertices(), vertices + copies);
  EXPECT_EQ(joined.non_manifold_vertices, split.size());
  for (std::size_t i = 0; i < copies; ++i)
    EXPECT_EQ(joined.mesh.point(VertexHandle(int(vertices + i))),
              joined.mesh.point(VertexHandle(int(joined.copied[i]))));
}

/// How many edges of any but folded triangles have so many, and how many of the pairs run one way.
void expect_counts(const HalfEdges& joined, const Triangles& triangles) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<bool>> edges;
  std::uint64_t folded = 0;
  for (const Corners& t : triangles) {
    const bool is_folded = std::set(t.begin(), t.end()).size() < 3;
    folded += is_folded;
    for (std::size_t k = 0; k < 3 && !is_folded; ++k)
      edges[std::minmax(t[k], t[(k + 1) % 3])].push_back(t[k] < t[(k + 1) % 3]);
  }
  std::uint64_t boundary = 3 * folded, more = 0, misoriented = 0, apart = 0;
  for (const auto& [edge, ways] : edges) {
    boundary += ways.size() == 1;
    more += ways.size() > 2;
    misoriented += ways.size() == 2 && ways[0] == ways[1];
    apart += ways.size() > 2 || (ways.size() == 2 && ways[0] == ways[1]) ? ways.size() - 1 : 0;
  }
  EXPECT_EQ(joined.folded_triangles, folded);
  EXPECT_EQ(joined.boundary_edges, boundary);
  EXPECT_EQ(joined.non_manifold_edges, more);
  EXPECT_EQ(joined.misoriented_edges, misoriented);
  EXPECT_EQ(joined.apart.size(), apart);
}

TEST(PropertyHalfEdges, SoupsAreJoinedAsASearchOfAllPairsJoinsThem) {
  std::mt19937 random(1);
  std::uint64_t manifolds = 0, crossings = 0, splits = 0;
  for (int i = 0; i < 300; ++i) {
    constexpr std::uint32_t vertices = 20;
    const Triangles triangles = random_soup(random, vertices);
    const HalfEdges joined = join(vertices, triangles);
    EXPECT_EQ(joined.mesh.n_faces(), triangles.size());
    expect_sound(joined.mesh);
    expect_as_searched(joined, triangles, vertices);
    expect_counts(joined, triangles);
    manifolds += joined.is_manifold();
    crossings += joined.non_manifold_edges;
    splits += joined.non_manifold_vertices;
    if (HasFailure()) return;
  }
  EXPECT_GT(crossings, 0u);
  EXPECT_GT(splits, crossings);
  RecordProperty("manifolds", int(manifolds));
}

}  // namespace
}  // namespace pellucid::geometry
