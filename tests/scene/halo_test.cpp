// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/halo.h"

#include <gtest/gtest.h>

#include "scene/view_depth.h"

namespace pellucid::scene {
namespace {

/// A line along x at z = 1, seen from z = 5 on.
Scene line_scene(Projection projection) {
  Scene scene;
  scene.camera = {.projection = projection, .eye = {0, 0, 5}};
  scene.background = Vec3(0.1, 0.2, 0.3);
  LineObject lines;
  lines.radius = 0.1;
  lines.halo = Halo{.width = 0.3, .depth = 0.5, .color = {}};
  for (int i = 0; i < 3; ++i) {
    lines.set.positions.emplace_back(i - 1, 0, 1);
    lines.set.colors.emplace_back(1, 0, 0, 0.25f * float(i + 1));
    lines.set.importance.push_back(0.5f * float(i));
  }
  lines.set.offsets = {0, 3};
  scene.objects = {{"line", lines}, {"other", geometry::TriangleMesh{}}};
  return scene;
}

TEST(UnitHalo, RecedesFromTheRimsOfItsLine) {
  Scene scene = line_scene(Projection::orthographic);
  place_halos(scene);
  ASSERT_EQ(scene.objects.size(), 3u);
  EXPECT_EQ(scene.objects[1].name, "line, halo");
  const geometry::TriangleMesh& halo = scene.objects[1].mesh();
  EXPECT_EQ(halo.triangles.size(), 2u * 2u * 2u);  // sides, segments, triangles
  ASSERT_EQ(halo.positions.size(), 2u * 3u * 2u);
  for (std::size_t i = 0; i < halo.positions.size(); i += 2) {
    const Vec3 &rim = halo.positions[i], &outer = halo.positions[i + 1];
    const double side = i < 6 ? -1 : 1;
    const std::size_t point = i / 2 % 3;
    // Coordinates up to 1 come from a few products with unit vectors, whose parts are 0 and 1 but
    // for their lengths: an ulp or two below 1.
    EXPECT_LT(glm::length(rim - Vec3(double(point) - 1, rim.y, 1)), 1e-15);
    EXPECT_NEAR(std::abs(rim.y), 0.1, 1e-15);
    EXPECT_EQ(rim.y * side > 0, halo.positions[0].y < 0);  // the two sides are opposite ones
    EXPECT_LT(glm::length(outer - Vec3(rim.x, 4 * rim.y, 0.5)), 1e-15);
    EXPECT_EQ(halo.colors[i], Rgba(0.1, 0.2, 0.3, 0.25f * float(point + 1)));
    EXPECT_EQ(halo.importance[i + 1], 0.5f * float(point));
  }
}

TEST(UnitHalo, RecedesAlongTheLineOfSight) {
  Scene scene = line_scene(Projection::perspective);
  place_halos(scene);
  const geometry::TriangleMesh& halo = scene.objects[1].mesh();
  for (std::size_t i = 0; i < halo.positions.size(); i += 2) {
    const Vec3 x(double(i / 2 % 3) - 1, 0, 1);
    const Vec3 away = glm::normalize(x - scene.camera.eye);
    const Vec3 behind = halo.positions[i + 1] - x - 4.0 * (halo.positions[i] - x);
    // Some ten roundings of numbers up to 5, half an ulp or 4.4e-16 each, and two of unit vectors.
    EXPECT_LT(glm::length(behind - 0.5 * away), 1e-14);
    EXPECT_LT(glm::length(halo.normals[i] + away), 1e-15);
  }
}

TEST(UnitHalo, IsMadeAnewForAnotherCamera) {
  Scene scene = line_scene(Projection::orthographic);
  place_halos(scene);
  const auto before = scene.objects[1].mesh().positions;
  scene.camera.eye = Vec3(0, 5, 0.5);
  scene.camera.up = Vec3(0, 0, 1);
  place_halos(scene);
  ASSERT_EQ(scene.objects.size(), 3u);
  EXPECT_NE(scene.objects[1].mesh().positions, before);
  EXPECT_EQ(scene.objects[2].name, "other");
}

}  // namespace
}  // namespace pellucid::scene
