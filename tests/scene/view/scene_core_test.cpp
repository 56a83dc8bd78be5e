// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/scene_core.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "scene/scene_fit.h"

namespace pellucid::scene {
namespace {

SceneObject points_at(const std::vector<Vec3>& places, double radius, float opacity = 1) {
  PointObject points;
  points.radius = radius;
  points.set.positions = places;
  points.set.colors.assign(places.size(), Rgba(1, 1, 1, opacity));
  SceneObject object;
  object.name = "points";
  object.shape = points;
  return object;
}

/// 1001 points evenly on the x axis, from -1 to 1.
std::vector<Vec3> row_of_points() {
  std::vector<Vec3> places;
  for (int i = -500; i <= 500; ++i) places.emplace_back(i / 500.0, 0, 0);
  return places;
}

Scene scene_of(std::vector<SceneObject> objects) {
  Scene scene;
  scene.objects = std::move(objects);
  return scene;
}

TEST(UnitSceneCore, WhatTrailsOffEvenlyIsKeptWhole) {
  const SceneCore core = scene_core(scene_of({points_at(row_of_points(), 0.1)}));
  EXPECT_NEAR(core.center.x, 0, 1e-12);
  // 98 % of the points are within 0.98 of the middle, to a point's distance.
  EXPECT_NEAR(core.radius, 1.25 * 0.98, 1.25 * 0.004);
  EXPECT_TRUE(core.outliers.empty());
}

TEST(UnitSceneCore, WhatLiesFarAwayIsNamedAndNotSeen) {
  std::vector<Vec3> places = row_of_points();
  places.insert(places.end(), 10, Vec3(0, 50, 0));
  const Scene scene = scene_of({points_at(places, 0.1)});
  const SceneCore core = scene_core(scene);
  ASSERT_EQ(core.outliers.size(), 1u);
  EXPECT_EQ(core.outliers[0].object, "points");
  EXPECT_EQ(core.outliers[0].count, 10u);
  EXPECT_NEAR(core.outliers[0].distance, 50, 0.01);
  // From the front, balls of 0.1 along 2: 2.2 wide, so that the picture is filled as if nothing
  // else were there.
  const Camera camera = core_camera(scene, core, view_directions()[6]);
  const Camera alone =
      core_camera(scene_of({points_at(row_of_points(), 0.1)}), core, view_directions()[6]);
  EXPECT_NEAR(glm::length(camera.eye - alone.eye), 0, 1e-12);
  EXPECT_LT(glm::length(camera.eye), 4);
}

/// A point of radius 0 is not drawn: neither camera looks for it, and nobody names it.
TEST(UnitSceneCore, PointsOfRadiusZeroDoNotWidenTheView) {
  std::vector<Vec3> places = row_of_points();
  const Scene alone = scene_of({points_at(places, 0.1)});
  std::vector<double> radii(places.size(), 0.1);
  places.emplace_back(0, 1e6, 0);
  radii.push_back(0);
  SceneObject object = points_at(places, 0.1);
  std::get<PointObject>(object.shape).radius = Radii(radii);
  const Scene scene = scene_of({object});
  EXPECT_EQ(fitted_camera(scene).eye, fitted_camera(alone).eye);
  const SceneCore core = scene_core(scene);
  EXPECT_TRUE(core.outliers.empty());
  EXPECT_EQ(core_camera(scene, core, view_directions()[0]).eye,
            core_camera(alone, core, view_directions()[0]).eye);
}

TEST(UnitSceneCore, WhatIsNearlyTransparentHardlyCounts) {
  // As many points far away, but of a thousandth of the opacity.
  std::vector<Vec3> far(1000, Vec3(0, 50, 0));
  const Scene scene = scene_of({points_at(row_of_points(), 0.1), points_at(far, 0.1, 0.001f)});
  EXPECT_EQ(scene_core(scene).outliers.size(), 1u);
  const Scene opaque = scene_of({points_at(row_of_points(), 0.1), points_at(far, 0.1, 1)});
  EXPECT_TRUE(scene_core(opaque).outliers.empty());
}

TEST(UnitSceneCore, MeshesCountByAreaAndLinesByLength) {
  // A triangle of area 50 against a thousand of 0.0005 each, far away.
  geometry::TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {10, 0, 0}, {0, 10, 0}};
  mesh.triangles = {{0, 1, 2}};
  for (std::uint32_t i = 0; i < 1000; ++i) {
    for (const Vec3& x : {Vec3(500, 0, 0), Vec3(500.1, 0, 0), Vec3(500, 0.01, 0)})
      mesh.positions.push_back(x);
    mesh.triangles.push_back({3 * i + 3, 3 * i + 4, 3 * i + 5});
  }
  SceneObject object;
  object.name = "mesh";
  object.shape = mesh;
  const SceneCore of_mesh = scene_core(scene_of({object}));
  ASSERT_EQ(of_mesh.outliers.size(), 1u);
  EXPECT_EQ(of_mesh.outliers[0].count, 3000u);
  // A line of length 100, and one of 0.1 of as many points.
  LineObject lines;
  lines.radius = 1;
  for (int i = 0; i <= 100; ++i) lines.set.positions.emplace_back(i, 0, 0);
  for (int i = 0; i <= 100; ++i) lines.set.positions.emplace_back(900 + 0.001 * i, 0, 0);
  lines.set.offsets = {0, 101, 202};
  object.shape = lines;
  const SceneCore of_lines = scene_core(scene_of({object}));
  ASSERT_EQ(of_lines.outliers.size(), 1u);
  EXPECT_EQ(of_lines.outliers[0].count, 101u);
}

TEST(UnitSceneCore, OfASceneThatIsAllTransparentAllIsKept) {
  std::vector<Vec3> places = row_of_points();
  places.emplace_back(0, 50, 0);
  EXPECT_TRUE(scene_core(scene_of({points_at(places, 0.1, 0)})).outliers.empty());
}

}  // namespace
}  // namespace pellucid::scene
