// SPDX-License-Identifier: GPL-3.0-or-later
// Radii, one or many, and all of the scene that looks at them: depths, halos, cameras, parts.
#include "scene/view/radii.h"

#include <gtest/gtest.h>

#include "scene/halo.h"
#include "scene/parts/scene_part.h"
#include "scene/scene_fit.h"
#include "scene/view/ribbon.h"
#include "scene/view_depth.h"
#include "tests/support/scenes.h"

namespace pellucid::scene {
namespace {

TEST(UnitRadii, EqualOnesAreOne) {
  const Radii equal(std::vector<double>(5, 0.25)), different(std::vector{0.5, 0.0, 1.0});
  EXPECT_EQ(equal, Radii(0.25));
  EXPECT_FALSE(equal.vary());
  EXPECT_TRUE(different.vary());
  EXPECT_EQ(different.largest(), 1);
  EXPECT_EQ(different.at(0), 0.5);
  EXPECT_EQ(different.of(0, 2).largest(), 0.5);
  EXPECT_EQ(different.of(1, 2).at(1), 1);
  EXPECT_EQ(equal.of(3, 2).at(1), 0.25);
  Radii doubled = different;
  doubled *= 2;
  EXPECT_EQ(doubled, Radii(std::vector{1.0, 0.0, 2.0}));
}

std::vector<Vec3> along_x(std::size_t n) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < n; ++i) points.emplace_back(double(i), 0, 0);
  return points;
}

SceneObject line(std::vector<double> radii, LineObject::Profile profile) {
  LineObject lines;
  lines.set.positions = along_x(radii.size());
  lines.set.colors.assign(radii.size(), Rgba(0.5));
  lines.set.offsets = {0, radii.size()};
  lines.radius = Radii(std::move(radii));
  lines.profile = profile;
  return {"line", lines};
}

SceneObject points(std::vector<double> radii, PointObject::Profile profile) {
  PointObject object;
  object.set.positions = along_x(radii.size());
  object.set.colors.assign(radii.size(), Rgba(0.5));
  object.radius = Radii(std::move(radii));
  object.profile = profile;
  return {"points", object};
}

/// Seen along -z from a distance of 10.
Scene scene_of(SceneObject object) {
  Scene scene = testing::empty_scene(64, 64);
  scene.camera.eye = {1, 0, 10};
  scene.camera.target = {1, 0, 0};
  scene.camera.height = 20;
  scene.objects = {std::move(object)};
  return scene;
}

TEST(UnitRadii, DepthsReachAsFarAsTheLargestSolid) {
  for (const SceneObject& object : {line({0.5, 2, 0}, LineObject::Profile::tube),
                                    points({0.5, 2, 0}, PointObject::Profile::sphere)}) {
    const DepthRange range = depth_range(scene_of(object));
    EXPECT_NEAR(range.near, 8, 1e-3);
    EXPECT_NEAR(range.far, 12, 1e-3);
  }
}

// What is farther away is not drawn.
TEST(UnitRadii, APointOfRadiusZeroHasNoDepth) {
  SceneObject object = points({0.5, 1, 0}, PointObject::Profile::sphere);
  object.vertices().positions[2].z = -50;
  EXPECT_NEAR(depth_range(scene_of(object)).far, 11, 1e-3);
}

TEST(UnitRadii, AFittedCameraSeesEachBall) {
  const auto seen = [](const std::vector<double>& radii) {
    const Scene scene = scene_of(points(radii, PointObject::Profile::sphere));
    return fitted_camera(scene, view_directions()[6]).height * 15 / 16;  // from the front
  };
  EXPECT_NEAR(seen({0.25, 0.5, 0.25}), 2.5, 1e-12);  // from x = -0.25 to x = 2.25
  EXPECT_NEAR(seen({0, 0.5, 0}), 1, 1e-12);          // a ball of radius 0 is none
}

TEST(UnitRadii, ARibbonIsAsWideAsItsRadiusAtEachPoint) {
  const std::vector<double> radii{0, 0.25, 0, 1, 0.5};
  const Scene scene = scene_of(line(radii, LineObject::Profile::ribbon));
  std::vector<Vec3> widths;
  const auto& lines = std::get<LineObject>(scene.objects[0].shape);
  ribbon_half_widths(lines.set.positions, lines.radius.of(0, radii.size()),
                     camera_frame(scene.camera), scene.camera.projection, widths);
  for (std::size_t i = 0; i < radii.size(); ++i) {
    EXPECT_NEAR(glm::length(widths[i]), radii[i], 1e-15);
    EXPECT_GE(glm::dot(widths[i], widths[3]), 0);  // on one side, across the tips
  }
}

TEST(UnitRadii, AHaloIsOneWidthWiderThanTheRibbonEverywhere) {
  const std::vector<double> radii{0.2, 0.4, 0};
  Scene scene = scene_of(line(radii, LineObject::Profile::ribbon));
  std::get<LineObject>(scene.objects[0].shape).halo = Halo{.width = 0.3, .depth = 0, .color = {}};
  place_halos(scene);
  const geometry::TriangleMesh& halo = scene.objects[1].mesh();
  ASSERT_EQ(halo.positions.size(), 12u);
  for (std::size_t i = 0; i < 12; i += 2) {
    const double radius = radii[i / 2 % 3];
    EXPECT_NEAR(std::abs(halo.positions[i].y), radius, 1e-15);
    EXPECT_NEAR(std::abs(halo.positions[i + 1].y), radius + 0.3, 1e-15);
  }
}

TEST(UnitRadii, PartsHaveThoseOfTheirPoints) {
  std::vector<double> radii;
  for (int i = 0; i < 9; ++i) radii.push_back(0.1 * i);
  SceneObject lines = line(radii, LineObject::Profile::tube);
  std::get<LineObject>(lines.shape).set.offsets = {0, 2, 5, 7, 9};
  for (const SceneObject& whole : {points(radii, PointObject::Profile::disc), lines}) {
    std::size_t seen = 0;
    for (int part = 1; part <= 3; ++part) {
      SceneObject object = whole;
      cut_object(object, share_of_cells(shared_elements(whole, PartOf::all_objects), 0, {part, 3}));
      const std::vector<Vec3>& x = object.vertices().positions;
      for (std::size_t i = 0; i < x.size(); ++i, ++seen)
        EXPECT_EQ(object.radii().at(i), 0.1 * x[i].x);
    }
    EXPECT_EQ(seen, 9u);
  }
}

}  // namespace
}  // namespace pellucid::scene
