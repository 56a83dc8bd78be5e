// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/views/rank_views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compare/views/contact_sheet.h"
#include "scene/view/unit_scale.h"

namespace pellucid::compare {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// Squares of side 2 at these heights, parallel to the xy plane.
scene::SceneObject sheets(const std::vector<double>& heights, float opacity, float importance = 0) {
  geometry::TriangleMesh mesh;
  for (const double z : heights) {
    const auto first = std::uint32_t(mesh.positions.size());
    for (const Vec3& x : {Vec3(-1, -1, z), Vec3(1, -1, z), Vec3(1, 1, z), Vec3(-1, 1, z)})
      mesh.positions.push_back(x);
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
  }
  mesh.colors.assign(mesh.positions.size(), Rgba(1, 0, 0, opacity));
  if (importance > 0) mesh.importance.assign(mesh.positions.size(), importance);
  scene::SceneObject object;
  object.shape = mesh;
  return object;
}

scene::Scene scene_of(scene::SceneObject object) {
  scene::Scene scene;
  scene.width = scene.height = 40;
  scene.camera = {.projection = scene::Projection::orthographic,
                  .eye = {0, 0, 5},
                  .target = {0, 0, 0},
                  .height = 4};
  scene.objects.push_back(std::move(object));
  return scene;
}

TEST(UnitViewScore, LayersBehindTooMuchAreHidden) {
  // Half the picture's width: a quarter is covered. Before layer k lies 0.1^(k - 1): the fourth
  // changes the pixel by 0.9e-3, less than 1/255.
  const ViewScore score = view_score(scene_of(sheets({0, 0.1, 0.2, 0.3, 0.4}, 0.9f, 0.5f)));
  EXPECT_NEAR(score.covered, 0.25, 1e-12);
  EXPECT_NEAR(score.layers, 3, 1e-12);
  EXPECT_NEAR(score.hidden, 0.4, 1e-12);
  EXPECT_NEAR(score.importance, 0.25 * 0.5 * (1 - std::pow(0.1, 5)), 1e-6);
  EXPECT_EQ(view_score(scene_of(sheets({0}, 0.9f))).importance, 0);
}

TEST(UnitRankViews, SidesLieEvenlyAroundTheSphereBelowTheCaps) {
  // Of `up` the direction counts: squares of the last two are infinite, and 0.
  for (const Vec3& up : {Vec3(0, 1, 0), Vec3(0, 0, 2), Vec3(1, -2, 3), 1e200 * Vec3(1, -2, 3),
                         1e-200 * Vec3(1, -2, 3)}) {
    Vec3 sum(0);
    for (const SphereView& view : sphere_views(200, up)) {
      const Vec3 toward = view.direction.toward_eye;
      EXPECT_NEAR(glm::length(toward), 1, 1e-12);
      EXPECT_NEAR(glm::dot(toward, scene::normalized_or_zero(up)),
                  std::sin(view.elevation * degree), 1e-12);
      EXPECT_LT(std::abs(view.elevation), 70);
      sum += toward;
    }
    EXPECT_LT(glm::length(sum) / 200, 0.01);
  }
}

TEST(UnitRankViews, SheetsAreBestSeenFromTheirFront) {
  scene::Scene scene = scene_of(sheets({-0.1, 0, 0.1}, 0.3f));
  const auto views = rank_views(scene, scene::scene_core(scene), 64, 16, {});
  ASSERT_GE(views.size(), 2u);
  EXPECT_LT(views.size(), 64u);  // there are no more so far apart
  const auto from = [&](std::size_t i) {
    return glm::normalize(views[i].camera.eye - views[i].camera.target);
  };
  // One of 32 sides lies within 20 degrees of each axis' ends, and edge-on nothing is seen.
  EXPECT_GT(std::abs(from(0).z), std::cos(25 * degree));
  EXPECT_EQ(views[0].worth, 1);
  for (std::size_t i = 0; i < views.size(); ++i) {
    EXPECT_LE(views[i].worth, views[i - std::min<std::size_t>(i, 1)].worth);
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_LT(glm::dot(from(i), from(k)), std::cos(30 * degree));
  }
}

TEST(UnitContactSheet, PicturesLieInAGridTheBestFirst) {
  scene::Scene scene = scene_of(sheets({-0.1, 0, 0.1}, 0.3f));
  std::vector<RankedView> views(5);
  views[0].score.covered = 0.25;
  const std::vector<Image> pictures(5, Image(20, 10));
  const FigureSheet sheet = contact_sheet(views, pictures, [](const auto&, double) { return 1.0; });
  ASSERT_EQ(sheet.pictures.size(), 5u);
  EXPECT_EQ(sheet.pictures[2].box.y, sheet.pictures[0].box.y);  // three columns
  EXPECT_EQ(sheet.pictures[3].box.x, sheet.pictures[0].box.x);
  EXPECT_NEAR(sheet.pictures[0].box.width, 2 * sheet.pictures[0].box.height, 1e-12);
  EXPECT_EQ(sheet.texts[1].runs[0].text, "covered 25 %, layers 0.0, hidden 0 %");
  EXPECT_GT(sheet.pictures[3].box.y, sheet.texts[1].at.y);
}

}  // namespace
}  // namespace pellucid::compare
