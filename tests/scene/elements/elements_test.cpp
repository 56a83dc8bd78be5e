// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of lines and surfaces that share an opacity: closed forms of chains, and properties of
// patches.

#include "scene/elements/elements.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "tests/support/scenes.h"
#include "tests/support/woven_mesh.h"

namespace pellucid::scene {
namespace {

using namespace testing;

/// One object of lines along x, each from 0 by steps of the lengths given.
SceneObject lines_of(const std::vector<std::vector<double>>& steps) {
  LineObject lines;
  for (const auto& line : steps) {
    double x = 0;
    lines.set.positions.emplace_back(x, 0, 0);
    for (const double step : line) lines.set.positions.emplace_back(x += step, 0, 0);
    lines.set.offsets.push_back(lines.set.positions.size());
  }
  return {"lines", lines};
}

Scene scene_of(std::vector<SceneObject> objects) {
  Scene scene;
  scene.objects = std::move(objects);
  return scene;
}

TEST(UnitElements, LinesAreCutIntoEqualLengths) {
  // 10 and 30 long: 2 and 6 of the 8 elements, 5 and 20 segments in each.
  const Elements e = line_elements(
      scene_of({lines_of({std::vector<double>(10, 1.0), std::vector<double>(120, 0.25)})}), 8);
  ASSERT_EQ(e.count(), 8u);
  ASSERT_EQ(e.of_primitive.size(), 130u);
  for (std::size_t i = 0; i < 130; ++i)
    EXPECT_EQ(e.of_primitive[i], i < 10 ? i / 5 : 2 + (i - 10) / 20) << i;
  const std::vector<std::size_t> neighbours = {1, 1, 1, 2, 2, 2, 2, 1};
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(e.neighbours[i].size(), neighbours[i]) << i;
  EXPECT_EQ(e.neighbours[1][0], 0u);  // and not the next line's
}

// Interpolation between the elements' middles reproduces what is linear along the line.
TEST(UnitElements, VerticesOfLinesInterpolateLinearly) {
  const Elements e = line_elements(scene_of({lines_of({std::vector<double>(40, 0.5)})}), 5);
  const std::vector<float> middles = {2, 6, 10, 14, 18};
  const std::vector<float> vertices = vertex_opacities(e, middles);
  for (std::size_t i = 0; i < vertices.size(); ++i)
    // Four roundings, of the weight, two products and the sum, of floats up to 18: 4 · 18 · 6e-8.
    EXPECT_NEAR(vertices[i], std::clamp(0.5 * double(i), 2.0, 18.0), 1e-5) << i;
}

TEST(UnitElements, ElementsEndAtPointsAndAreNeverEmpty) {
  // Finer than the line's points: an element for each segment, whatever their lengths.
  const Elements fine = line_elements(scene_of({lines_of({{1, 5, 0.1, 3}})}), 1000);
  EXPECT_EQ(fine.count(), 4u);
  EXPECT_EQ(fine.of_primitive, (std::vector<std::uint32_t>{0, 1, 2, 3}));
  // Lines of no point, of one, of no length; one element is enough for all others.
  const Elements odd = line_elements(scene_of({lines_of({{}, {0, 0}, {2, 2}})}), 1);
  EXPECT_EQ(odd.of_primitive, (std::vector<std::uint32_t>{0, 0, 1, 1}));
  EXPECT_EQ(odd.of_vertex.count(), 7u);
  EXPECT_EQ(vertex_opacities(odd, {0.25f, 0.5f}),
            (std::vector<float>{1, 0.25f, 0.25f, 0.25f, 0.5f, 0.5f, 0.5f}));
}

TEST(UnitElements, OpaqueObjectsAreCountedOnly) {
  SceneObject context = lines_of({{1, 1, 1}});
  context.opaque = true;
  const Elements e = line_elements(scene_of({context, lines_of({{1, 1}})}), 1);
  EXPECT_EQ(e.count(), 1u);
  EXPECT_EQ(e.of_primitive.size(), 5u);
  EXPECT_EQ(vertex_opacities(e, {0.5f}), (std::vector<float>{1, 1, 1, 1, 0.5f, 0.5f, 0.5f}));
}

// On a chain an iteration is the filter 1/4, 1/2, 1/4: s of them have variance s / 2.
TEST(UnitElements, SmoothingALineIsABinomialFilter) {
  const Elements e = line_elements(scene_of({lines_of({std::vector<double>(101, 1.0)})}), 101);
  std::vector<float> opacities(101, 0.0f);
  opacities[50] = 1;
  smooth(e, 15, opacities);
  double sum = 0, variance = 0;
  for (int i = 0; i < 101; ++i) {
    sum += opacities[std::size_t(i)];
    variance += (i - 50.0) * (i - 50.0) * opacities[std::size_t(i)];
  }
  // Fifteen iterations of three roundings each, 6e-8 of what they round: 3e-6 of the sum; the
  // variance is seven and a half times that.
  EXPECT_NEAR(sum, 1, 3e-6);
  EXPECT_NEAR(variance, 7.5, 7.5 * 3e-6);
  EXPECT_EQ(opacities[50 + 16], 0);  // s elements far and no farther
  EXPECT_GT(opacities[50 + 15], 0);
  std::vector<float> constant(101, 0.3f);
  smooth(e, 15, constant);
  EXPECT_EQ(constant, std::vector<float>(101, 0.3f));
}

geometry::TriangleMesh grid(std::uint32_t n) {
  return testing::woven_mesh(n, [](double x, double y) { return Vec3(x, y, 0); });
}

std::vector<int> sizes(const Elements& e) {
  std::vector<int> sizes(e.count());
  for (const std::uint32_t element : e.of_primitive) ++sizes.at(element);
  return sizes;
}

class PropertyPatches : public ::testing::TestWithParam<SurfaceDistance> {};
INSTANTIATE_TEST_SUITE_P(, PropertyPatches,
                         ::testing::Values(SurfaceDistance::edges, SurfaceDistance::heat),
                         [](const auto& distance) {
                           return distance.param == SurfaceDistance::heat ? "heat" : "edges";
                         });

TEST_P(PropertyPatches, CoverASurfaceEvenly) {
  const Elements e = surface_elements(scene_of({{"grid", grid(60)}}), 50, GetParam());
  EXPECT_EQ(e.count(), 50u);
  const std::vector<int> triangles = sizes(e);
  EXPECT_EQ(std::accumulate(triangles.begin(), triangles.end(), 0), 7200);
  // Farthest points are at least R from each other and cover by circles of R: cells have between
  // the area of a circle of R / 2 and of R; those at the rim half or a quarter of it.
  EXPECT_GE(*std::ranges::min_element(triangles), 7200 / 50 / 6);
  EXPECT_LE(*std::ranges::max_element(triangles), 7200 / 50 * 4);
  for (std::uint32_t i = 0; i < 50; ++i) {
    EXPECT_FALSE(e.neighbours[i].empty());
    for (const std::uint32_t j : e.neighbours[i]) {
      EXPECT_NE(i, j);
      EXPECT_NE(std::ranges::find(e.neighbours[j], i), e.neighbours[j].end());
    }
  }
}

// A mean changes little from vertex to vertex, and leaves the hull of what it is of nowhere.
TEST_P(PropertyPatches, AreMixedContinuouslyByVertices) {
  const Elements e = surface_elements(scene_of({{"grid", grid(60)}}), 50, GetParam());
  std::vector<float> opacities(e.count());
  for (std::size_t i = 0; i < opacities.size(); ++i) opacities[i] = float(i % 2);
  const std::vector<float> vertices = vertex_opacities(e, opacities);
  EXPECT_LE(*std::ranges::max_element(vertices), 1);
  // Weights of vertices that are h apart differ by h / R times a few; h = 1/60, R about 1/7.
  for (std::size_t i = 0; i + 1 < 61; ++i)
    EXPECT_LT(std::abs(vertices[30 * 61 + i + 1] - vertices[30 * 61 + i]), 0.5f) << i;
  EXPECT_EQ(vertex_opacities(e, std::vector<float>(e.count(), 0.5f)).size(), 61u * 61);
  for (const float v : vertex_opacities(e, std::vector<float>(e.count(), 0.3f))) EXPECT_EQ(v, 0.3f);
}

/// How much longer patches are along the grid's diagonals, which are edges, than across these: the
/// quotient of the mean squares.
double slant(const geometry::TriangleMesh& mesh, const Elements& e) {
  const auto middle = [&](std::size_t t) {
    const auto& [a, b, c] = mesh.triangles[t];
    return (mesh.positions[a] + mesh.positions[b] + mesh.positions[c]) / 3.0;
  };
  std::vector<Vec3> sums(e.count(), Vec3(0));
  std::vector<double> counts(e.count());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    sums[e.of_primitive[t]] += middle(t);
    ++counts[e.of_primitive[t]];
  }
  double along = 0, across = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::uint32_t i = e.of_primitive[t];
    const Vec3 x = middle(t) - sums[i] / counts[i];
    along += (x.x + x.y) * (x.x + x.y);
    across += (x.x - x.y) * (x.x - x.y);
  }
  return along / across;
}

TEST(UnitElements, PatchesByHeatDoNotFollowTheEdges) {
  const geometry::TriangleMesh mesh = grid(60);
  const Scene scene = scene_of({{"grid", mesh}});
  EXPECT_GT(slant(mesh, surface_elements(scene, 50, SurfaceDistance::edges)), 1.3);
  EXPECT_NEAR(slant(mesh, surface_elements(scene, 50, SurfaceDistance::heat)), 1, 0.2);
}

TEST(PropertyElements, PiecesThatDoNotHangTogetherShareNothing) {
  geometry::TriangleMesh far = grid(4);
  for (Vec3& x : far.positions) x.x += 10;
  const Elements e = surface_elements(scene_of({{"a", grid(4)}, {"b", far}}), 1);
  EXPECT_EQ(e.count(), 2u);
  EXPECT_TRUE(e.neighbours[0].empty() && e.neighbours[1].empty());
  EXPECT_EQ(sizes(e), (std::vector<int>{32, 32}));
  const std::vector<float> vertices = vertex_opacities(e, {0.0f, 1.0f});
  for (std::size_t i = 0; i < vertices.size(); ++i) EXPECT_EQ(vertices[i], i < 25 ? 0 : 1) << i;
}

TEST(PropertyElements, PatchesGoOnWhereAMeshIsNoManifold) {
  // Two squares that meet in a corner; a fin stands on an edge of the first one.
  geometry::TriangleMesh mesh = grid(4);
  const geometry::TriangleMesh first = mesh;
  for (std::size_t i = 1; i < first.positions.size(); ++i)
    mesh.positions.push_back(-first.positions[i]);
  for (const auto& triangle : first.triangles) {
    auto& turned = mesh.triangles.emplace_back(triangle);
    for (std::uint32_t& corner : turned) corner = corner == 0 ? 0 : corner + 24;
  }
  mesh.triangles.push_back({6, 7, std::uint32_t(mesh.positions.size())});
  mesh.positions.emplace_back(0.3, 0.3, 1);
  const Elements one = surface_elements(scene_of({{"mesh", mesh}}), 1);
  EXPECT_EQ(one.count(), 1u);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) EXPECT_EQ(one.of_vertex[v].size(), 1u);
  const Elements two = surface_elements(scene_of({{"mesh", mesh}}), 2);
  EXPECT_EQ(two.count(), 2u);
  EXPECT_EQ(two.neighbours[0].size(), 1u);
}

TEST(PropertyElements, AnyMeshIsCut) {
  // More patches than triangles; triangles of no area, three at one edge; no triangle at all.
  geometry::TriangleMesh odd;
  odd.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}, {5, 5, 5}};
  odd.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}, {5, 5, 5}, {1, 1, 2}};
  const Elements e = surface_elements(scene_of({{"odd", odd}}), 100);
  EXPECT_EQ(std::ranges::count(sizes(e), 0), 0);
  EXPECT_LE(e.count(), 5u);
  for (const float v : vertex_opacities(e, std::vector<float>(e.count(), 0.3f))) EXPECT_EQ(v, 0.3f);
  EXPECT_EQ(surface_elements(scene_of({{"none", geometry::TriangleMesh()}}), 100).count(), 0u);
  EXPECT_EQ(surface_elements(scene_of({{"soup", random_triangles(20, 3)}}), 5).count(), 20u);
}

}  // namespace
}  // namespace pellucid::scene
