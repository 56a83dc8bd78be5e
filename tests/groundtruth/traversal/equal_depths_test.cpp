// SPDX-License-Identifier: GPL-3.0-or-later
// What lies at equal depth is ordered by object, then by primitive, however it is stored.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>

#include "groundtruth/rays/plane_depth.h"
#include "groundtruth/sums/ray_sums.h"
#include "tests/support/scenes.h"

namespace pellucid::groundtruth {
namespace {

using namespace testing;
using geometry::TriangleMesh;

constexpr int side = 48;  // of the pictures, pixels

/// A turned view, whose rounding no coordinate escapes.
scene::Scene turned_scene(scene::Projection projection) {
  scene::Scene scene;
  scene.width = scene.height = side;
  scene.camera = {.projection = projection, .eye = {1, 2, 5}, .fov = 20, .height = 2};
  return scene;
}

/// Calls see(crossings) with what every ray crosses, of the finder and with rounded depths.
void for_each_ray(const scene::Scene& scene,
                  const std::function<void(const std::vector<Crossing>&)>& see) {
  const CrossingFinder finder(scene, Precision::exact);
  std::vector<Crossing> crossings;
  for (int y = 0; y < scene.height; ++y)
    for (int x = 0; x < scene.width; ++x) {
      const PictureRay ray = finder.frame().ray(x + 0.5, y + 0.5);
      finder.find(ray, crossings);
      see(crossings);
      finder.round_depths(ray, crossings);
      ASSERT_TRUE(std::is_sorted(crossings.begin(), crossings.end()));
    }
}

using Order = std::array<std::size_t, 3>;

TriangleMesh renumbered(TriangleMesh mesh, const Order& order) {
  for (auto& triangle : mesh.triangles) {
    const auto [a, b, c] = std::array{triangle[order[0]], triangle[order[1]], triangle[order[2]]};
    triangle = {a, b, c};
  }
  return mesh;
}

class PropertyEqualDepths : public ::testing::TestWithParam<scene::Projection> {};
INSTANTIATE_TEST_SUITE_P(Cameras, PropertyEqualDepths,
                         ::testing::Values(scene::Projection::perspective,
                                           scene::Projection::orthographic));

TEST_P(PropertyEqualDepths, OneMeshNumberedInTwoWaysIsInOrder) {
  const TriangleMesh soup = random_triangles(40, 3);
  for (const Order& order : {Order{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}}) {
    scene::Scene scene = turned_scene(GetParam());
    scene.objects = {{"", soup}, {"", renumbered(soup, order)}};
    std::size_t pairs = 0;
    for_each_ray(scene, [&](const std::vector<Crossing>& crossings) {
      ASSERT_EQ(crossings.size() % 2, 0u);
      for (std::size_t i = 0; i < crossings.size(); i += 2, ++pairs) {
        ASSERT_EQ(crossings[i].primitive, crossings[i + 1].primitive);
        ASSERT_EQ(crossings[i].object, 0u);
        ASSERT_EQ(crossings[i + 1].object, 1u);
      }
    });
    EXPECT_GT(pairs, std::size_t(side) * side);
  }
}

TEST_P(PropertyEqualDepths, FacesOfATwoSidedMeshAreInTheirOrder) {
  scene::Scene scene = turned_scene(GetParam());
  TriangleMesh mesh = random_triangles(40, 3);
  const std::size_t n = mesh.triangles.size();
  const TriangleMesh back = renumbered(mesh, {0, 2, 1});
  mesh.triangles.insert(mesh.triangles.end(), back.triangles.begin(), back.triangles.end());
  scene.objects = {{"", mesh}};
  for_each_ray(scene, [&](const std::vector<Crossing>& crossings) {
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
      ASSERT_EQ(crossings[i].primitive + n, crossings[i + 1].primitive);
  });
}

/// Of the plane z = x / 2 + y / 4 + offset, whose points in coordinates of few bits are exact.
TriangleMesh in_plane(const std::vector<Vec2>& points,
                      const std::vector<std::array<std::uint32_t, 3>>& triangles,
                      double offset = 0) {
  TriangleMesh mesh;
  for (const Vec2& p : points) mesh.positions.push_back({p.x, p.y, p.x / 2 + p.y / 4 + offset});
  mesh.triangles = triangles;
  mesh.colors.assign(points.size(), Rgba(0.5));
  mesh.normals.assign(points.size(), Vec3(0, 0, 1));
  return mesh;
}

const std::vector<Vec2> square{{-4, -4}, {4, -4}, {4, 4}, {-4, 4}};
const std::vector<Vec2> larger{{-5, -5}, {5, -5}, {5, 5}, {-5, 5}, {0.5, 0.25}};

std::vector<TriangleMesh> cuts_of_a_plane() {
  return {in_plane(square, {{0, 1, 2}, {0, 2, 3}}), in_plane(square, {{0, 1, 3}, {1, 2, 3}}),
          in_plane(larger, {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}})};
}

TEST_P(PropertyEqualDepths, SheetsOfOnePlaneCutInThreeWaysAreInOrder) {
  std::vector<TriangleMesh> sheets = cuts_of_a_plane();
  do {
    std::ranges::rotate(sheets, sheets.begin() + 1);
    scene::Scene scene = turned_scene(GetParam());
    for (const TriangleMesh& sheet : sheets) scene.objects.push_back({"", sheet});
    const RayProbe probe(scene);
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        const std::vector<RayLayer> layers = probe.at(x + 0.5, y + 0.5).layers;
        ASSERT_EQ(layers.size(), 3u);
        for (std::uint32_t i = 0; i < 3; ++i) {
          ASSERT_EQ(layers[i].object, i);
          ASSERT_EQ(layers[i].depth, layers[0].depth);  // to the last bit: what a merge compares
        }
      }
  } while (sheets[0].positions.size() != 4 || sheets[0].triangles[0][2] != 2);
}

TEST_P(PropertyEqualDepths, OfOpaqueSheetsOfOnePlaneTheFirstIsSeen) {
  scene::Scene scene = turned_scene(GetParam());
  for (const TriangleMesh& sheet : cuts_of_a_plane()) {
    scene.objects.push_back({"", sheet});
    scene.objects.back().opaque = true;
  }
  for_each_ray(scene, [&](const std::vector<Crossing>& crossings) {
    ASSERT_EQ(crossings.size(), 1u);
    ASSERT_EQ(crossings[0].object, 0u);
  });
}

/// 2^-40 is some hundred times what rounding moves, and a thousandth of what the filter lets pass.
TEST_P(PropertyEqualDepths, SheetsThatAreHardlyApartAreNotEqual) {
  scene::Scene scene = turned_scene(GetParam());
  scene.objects = {{"", in_plane(square, {{0, 1, 2}, {0, 2, 3}}, -0x1p-40)},
                   {"", in_plane(square, {{0, 1, 3}, {1, 2, 3}})}};
  for_each_ray(scene, [&](const std::vector<Crossing>& crossings) {
    ASSERT_EQ(crossings.size(), 2u);
    ASSERT_EQ(crossings[0].object, 1u);
  });
}

TEST_P(PropertyEqualDepths, ALineStoredBackwardsIsTheSame) {
  for (const auto profile :
       {scene::LineObject::Profile::ribbon, scene::LineObject::Profile::tube}) {
    scene::LineObject line{{}, 0.3, profile};
    line.set.positions = {{-1, -0.3, 0.2}, {0.2, 0.1, 0}, {1.1, 0.4, -0.3}};
    line.set.offsets = {0, 3};
    line.set.colors.assign(3, Rgba(0.5));
    scene::LineObject backwards = line;
    std::ranges::reverse(backwards.set.positions);
    scene::Scene scene = turned_scene(GetParam());
    scene.objects = {{"", line}, {"", backwards}};
    std::size_t pairs = 0;
    for_each_ray(scene, [&](const std::vector<Crossing>& crossings) {
      for (std::size_t i = 0; i < crossings.size(); ++i, ++pairs)
        ASSERT_EQ(crossings[i].object, i % 2);
    });
    EXPECT_GT(pairs, std::size_t(side));
  }
}

TEST(UnitPlaneDepth, ItIsTheExactDepthRoundedOnce) {
  // The plane z = 0.1 + 0 x, of corners whose weights sum to 1 but for rounding.
  const double z = 0.1;
  for (int k = 1; k < 200; ++k) {
    const PictureRay ray{0.3 / k, -0.7 / k, scene::Projection::perspective};
    EXPECT_EQ(view_plane_depth(ray, {Vec3(-1, -1.1, z), Vec3(1.3, -1, z), Vec3(0.1, 1.7, z)}), z);
  }
  // The plane z = 1 + x / 3: on the ray (x, y, 1) at 3 / (3 - x).
  for (int k = 1; k < 60; ++k) {
    const double x = k / 64.0;
    const std::array corners{Vec3(-3, -1, 0), Vec3(3, -1, 2), Vec3(0, 9, 1)};
    EXPECT_EQ(view_plane_depth({x, 0, scene::Projection::perspective}, corners), 3 / (3 - x)) << k;
  }
}

TEST(UnitPlaneDepth, ARayInThePlaneMeetsItAtTheCentre) {
  const std::array corners{Vec3(0, -1, 1), Vec3(0, 1, 2), Vec3(0, 0, 6)};
  EXPECT_EQ(view_plane_depth({0, 0, scene::Projection::perspective}, corners), 3);
}

}  // namespace
}  // namespace pellucid::groundtruth
