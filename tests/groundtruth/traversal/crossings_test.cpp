// SPDX-License-Identifier: GPL-3.0-or-later
// Each crossing once: rays aimed at edges and vertices of meshes with known numbers of crossings.

#include <gtest/gtest.h>

#include <atomic>

#include "core/parallel.h"
#include "groundtruth/shapes/crossing_geometry.h"
#include "groundtruth/traversal/crossing_finder.h"
#include "scene/view_depth.h"
#include "tests/support/scenes.h"

namespace pellucid::groundtruth {
namespace {

using namespace testing;

/// Picture coordinates (pixels) of a world point.
Vec2 picture_point(const scene::Scene& scene, const Vec3& x) {
  const scene::CameraFrame frame = scene::camera_frame(scene.camera);
  const double scale =
      scene.camera.projection == scene::Projection::perspective ? scene::view_depth(frame, x) : 1;
  const double pixel = 2 * scene::half_height(scene.camera) / scene.height * scale;
  return {scene.width / 2.0 + glm::dot(frame.right, x - frame.eye) / pixel,
          scene.height / 2.0 - glm::dot(frame.up, x - frame.eye) / pixel};
}

/// Rays at ±height/2 are far beyond what Embree takes for a ray.
TEST(UnitCrossings, APictureOfAnySizeHasItsRays) {
  for (const double height : {1., 1e10, 1e20, 1e30, 1e290}) {
    scene::Scene scene = orthographic_scene(8, 8);
    scene.camera.height = height;
    geometry::TriangleMesh sheet;
    for (const Vec2& corner : {Vec2(-1, -1), Vec2(1, -1), Vec2(0, 1)})
      sheet.positions.push_back({0.01 * height * corner.x, 0.01 * height * corner.y, 0});
    sheet.triangles = {{0, 1, 2}};
    scene.objects.push_back({"small", sheet});
    const CrossingFinder finder(scene, Precision::exact);
    std::vector<Crossing> crossings;
    for (const double x : {0.5, 4., 7.5}) {
      finder.find(finder.frame().ray(x, 4), crossings);
      EXPECT_EQ(crossings.size(), x == 4 ? 1u : 0u) << height << ", at " << x;
    }
  }
}

TEST(SlowCrossings, GridAlignedSheetsAreCoveredAsByARasterizer) {
  // Eight sheets of 95 × 95 cells, ten pixels wide, whose grid lines run through pixel centres from
  // 25.5 to 975.5: a top-left rule covers 950² pixels of each.
  scene::Scene scene = orthographic_scene(1000, 1000);
  scene.camera.height = 1000;
  for (int layer = 0; layer < 8; ++layer) {
    geometry::TriangleMesh sheet;
    for (int j = 0; j <= 95; ++j)
      for (int i = 0; i <= 95; ++i)
        sheet.positions.push_back({25.5 + 10 * i - 500, 500 - 25.5 - 10 * j, -layer});
    for (std::uint32_t j = 0; j < 95; ++j)
      for (std::uint32_t i = 0; i < 95; ++i) {
        const std::uint32_t v = 96 * j + i;
        sheet.triangles.push_back({v, v + 1, v + 97});
        sheet.triangles.push_back({v, v + 97, v + 96});
      }
    scene.objects.push_back({"sheet", sheet});
  }
  const CrossingFinder finder(scene, Precision::exact);
  std::atomic<std::uint64_t> total = 0;
  parallel_for(0, 1000, [&](int y) {
    constexpr int together = 8;  // rays
    std::array<std::vector<Crossing>, together> crossings;
    std::array<PictureRay, together> rays;
    for (int x = 0; x < 1000; x += together) {
      for (int k = 0; k < together; ++k)
        rays[std::size_t(k)] = finder.frame().ray(x + k + 0.5, y + 0.5);
      finder.find(rays, crossings);
      for (const std::vector<Crossing>& of_ray : crossings) total += of_ray.size();
    }
  });
  EXPECT_EQ(total, 7220000u);
}

class PropertyClosedMesh : public ::testing::TestWithParam<scene::Projection> {
 protected:
  scene::Scene scene() const {
    scene::Scene scene;
    scene.width = scene.height = 500;
    scene.camera = {.projection = GetParam(), .eye = {1.3, 0.7, 3}, .fov = 45, .height = 2.5};
    scene.objects = {{"sphere", sphere(5, Rgba(1))}};
    return scene;
  }
};

TEST_P(PropertyClosedMesh, RaysThroughVerticesAndEdgesCrossTwiceOrNever) {
  const scene::Scene world = scene();
  const CrossingFinder finder(world, Precision::exact);
  const geometry::TriangleMesh& mesh = world.objects[0].mesh();
  std::vector<Crossing> crossings;
  std::uint64_t twice = 0, rays = 0;
  const auto aim = [&](const Vec3& target) {
    const Vec2 p = picture_point(world, target);
    finder.find(finder.frame().ray(p.x, p.y), crossings);
    ++rays;
    twice += crossings.size() == 2;
    EXPECT_TRUE(crossings.empty() || crossings.size() == 2) << crossings.size();
  };
  for (const Vec3& vertex : mesh.positions) aim(vertex);
  for (const auto& [a, b, c] : mesh.triangles)
    for (const auto& [p, q] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
      aim(0.5 * (mesh.positions[p] + mesh.positions[q]));
  // A convex body: only rays at its outline may miss it.
  EXPECT_GT(twice, rays * 98 / 100);
}

TEST(UnitCrossings, RoundedSignsDoNotSuffice) {
  // The edge from a to b passes the ray at (0, 0) with a' × b' = -2 ε², which double rounds to 0:
  // the tie rule then takes the ray to lie on the wrong side.
  const double e = 0x1p-52;
  const Vec3 a(1 + 2 * e, 1 + 3 * e, 1), b(-1, -(1 + e), 1), right(1, -1, 1), left(-1, 1, 1);
  const PictureRay ray{0, 0, scene::Projection::orthographic};
  const RayPredicate exact(ray, 2, Precision::exact), rounded(ray, 2, Precision::rounded);
  EdgeFunctions edges;
  EXPECT_FALSE(exact.crosses(a, b, right, edges));
  EXPECT_TRUE(exact.crosses(a, b, left, edges));
  EXPECT_TRUE(rounded.crosses(a, b, right, edges));
  EXPECT_FALSE(rounded.crosses(a, b, left, edges));
}

INSTANTIATE_TEST_SUITE_P(Cameras, PropertyClosedMesh,
                         ::testing::Values(scene::Projection::perspective,
                                           scene::Projection::orthographic));

/// Meshes in float: as good as exact inside triangles, not at their edges.
TEST(UnitCrossings, FastFindsTheSameInsideTrianglesAndMiscountsVertices) {
  scene::Scene scene;
  scene.width = scene.height = 64;
  scene.objects = {{"", sphere(3, Rgba(1))}};
  const CrossingFinder exact(scene, Precision::exact), fast(scene, Precision::fast);
  std::vector<Crossing> expected, found;
  // Rounding moves ray and vertices by 4.2e-7 (BoxHierarchy::margin); where a facet is seen at a
  // slant, depth moves up to ten times as far.
  constexpr double tolerance = 5e-6;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      const PictureRay ray = exact.frame().ray(x + 0.5, y + 0.5);
      exact.find(ray, expected);
      fast.find(ray, found);
      ASSERT_EQ(found.size(), expected.size()) << x << " " << y;
      for (std::size_t i = 0; i < found.size(); ++i)
        EXPECT_NEAR(found[i].depth, expected[i].depth, tolerance);
    }

  int miscounted = 0;
  for (const Vec3& vertex : scene.objects[0].mesh().positions) {
    const Vec2 at = picture_point(scene, vertex);
    exact.find(exact.frame().ray(at.x, at.y), expected);
    fast.find(exact.frame().ray(at.x, at.y), found);
    miscounted += found.size() != expected.size();
  }
  EXPECT_GT(miscounted, 0);  // if never, fast is what exact is, and the documents are wrong
}

TEST(UnitCrossings, CoincidentSheetsAreAllKept) {
  scene::Scene scene = orthographic_scene(4, 4);
  for (int i = 0; i < 32; ++i) scene.objects.push_back({"", full_layer(0.25, Rgba(1))});
  const CrossingFinder finder(scene, Precision::exact);
  std::vector<Crossing> crossings;
  finder.find(finder.frame().ray(1.5, 1.5), crossings);
  ASSERT_EQ(crossings.size(), 32u);
  for (std::uint32_t i = 0; i < 32; ++i) EXPECT_EQ(crossings[i].object, i);
}

TEST(UnitCrossings, NothingBehindTheEyeCounts) {
  scene::Scene scene = orthographic_scene(2, 2);
  scene.camera.eye = {0, 0, 0};
  scene.camera.target = {0, 0, -1};
  for (const double z : {1.0, 1e-5, -1e-5, -1.0})
    scene.objects.push_back({"", full_layer(z, Rgba(1))});
  const CrossingFinder finder(scene, Precision::exact);
  std::vector<Crossing> crossings;
  finder.find(finder.frame().ray(0.5, 0.5), crossings);
  ASSERT_EQ(crossings.size(), 2u);
  EXPECT_EQ(crossings[0].object, 2u);
  EXPECT_EQ(crossings[1].object, 3u);
}

TEST(UnitCrossings, AFarAwayEyeMissesNothing) {
  // 1e6 away with a matching field of view: the rays are almost parallel.
  scene::Scene scene;
  scene.width = scene.height = 64;
  scene.camera = {.eye = {0, 0, 1e6}, .target = {0, 0, 0}, .fov = 1e-4};
  scene.objects = {{"", full_layer(0, Rgba(1))}, {"", full_layer(-0.5, Rgba(1))}};
  const CrossingFinder finder(scene, Precision::exact);
  std::vector<Crossing> crossings;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      finder.find(finder.frame().ray(x + 0.5, y + 0.5), crossings);
      ASSERT_EQ(crossings.size(), 2u);
    }
}

TEST(PropertyPacket, RaysFindTogetherWhatEachFindsAlone) {
  scene::Scene scene;
  scene.width = scene.height = 96;
  scene.objects = {{"", random_triangles(3000, 9)}, {"", sphere(3, Rgba(1))}};
  const CrossingFinder finder(scene, Precision::exact);
  std::array<std::vector<Crossing>, RayPacket::width> together;
  std::vector<Crossing> alone;
  std::size_t total = 0;
  for (int y = 0; y < 96; y += 4)
    for (int x = 0; x < 96; x += 4) {
      std::array<PictureRay, RayPacket::width> rays;
      for (std::size_t k = 0; k < rays.size(); ++k)
        rays[k] = finder.frame().ray(x + k % 4 + 0.5, y + k / 4 + 0.5);
      finder.find(rays, together);
      for (std::size_t k = 0; k < rays.size(); ++k) {
        finder.find(rays[k], alone);
        ASSERT_EQ(together[k], alone) << x << " " << y << " " << k;
        total += alone.size();
      }
    }
  EXPECT_GT(total, 96u * 96u * 10u);
}

TEST(PropertyOpaque, RaysEndWithTheFirstCrossingOfAnOpaqueObjectWhateverItsKind) {
  // Boxes behind an opaque crossing are not visited: the list has to be what it was up to there.
  scene::PointObject points;
  for (const Vec3& corner : random_triangles(10, 4).positions)
    points.set.positions.push_back(corner);
  points.set.colors.assign(points.set.positions.size(), Rgba(0.5));
  points.radius = 0.3;
  points.profile = scene::PointObject::Profile::disc;
  scene::PointObject spheres = points;
  spheres.profile = scene::PointObject::Profile::sphere;
  scene::Scene scene;
  scene.width = scene.height = 64;
  scene.objects = {
      {"", random_triangles(300, 9)}, {"", random_triangles(30, 5)}, {"", points}, {"", spheres}};
  std::vector<Crossing> ends, all;
  for (std::uint32_t opaque = 0; opaque < scene.objects.size(); ++opaque) {
    scene::Scene context = scene;
    context.objects[opaque].opaque = true;
    const CrossingFinder ending(context, Precision::exact), transparent(scene, Precision::exact);
    std::size_t hidden = 0;
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) {
        const PictureRay ray = ending.frame().ray(x + 0.5, y + 0.5);
        ending.find(ray, ends);
        transparent.find(ray, all);
        const auto stop = std::ranges::find(all, opaque, &Crossing::object);
        if (stop != all.end()) {
          hidden += std::size_t(all.end() - stop) - 1;
          all.erase(stop + 1, all.end());
        }
        ASSERT_EQ(ends, all) << opaque << ' ' << x << ' ' << y;
      }
    EXPECT_GT(hidden, 1000u);
  }
}

}  // namespace
}  // namespace pellucid::groundtruth
