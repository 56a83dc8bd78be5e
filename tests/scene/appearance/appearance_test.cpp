// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/appearance/appearance.h"

#include <gtest/gtest.h>

#include <limits>

#include "scene/appearance/colormap.h"
#include "tests/support/scenes.h"

namespace pellucid::scene {
namespace {

using namespace testing;

TEST(UnitAppearance, NormalsAreAreaWeighted) {
  geometry::TriangleMesh mesh = sphere(3, Rgba(1));
  mesh.normals.clear();
  ensure_normals(mesh);
  // On a regular subdivision of the sphere the mean of the facets deviates by 2.8° at most.
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    EXPECT_GT(std::abs(glm::dot(mesh.normals[i], mesh.positions[i])),
              std::cos(2.81 * std::numbers::pi / 180));
}

TEST(UnitColormap, EndsAndMiddleAreMatplotlibs) {
  const ColormapRow& viridis = find_colormap("viridis");
  EXPECT_EQ(viridis(0) * 255.0, Vec3(68, 1, 84));
  EXPECT_EQ(viridis(1) * 255.0, Vec3(253, 231, 37));
  EXPECT_EQ(viridis(-5), viridis(0));
  EXPECT_EQ(viridis(7), viridis(1));
}

geometry::Vertices with_scalar(const std::vector<double>& values) {
  geometry::Vertices vertices;
  vertices.positions.assign(values.size(), Vec3(0));
  vertices.scalars["s"] = values;
  return vertices;
}

Vec3 rgb(const Rgba& color) { return Vec3(Vec3(glm::vec3(color))); }

TEST(UnitAppearance, NanHasAColourOfItsOwn) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const ColormapRow& map : colormaps()) {
    EXPECT_EQ(map(nan), nan_color) << map.name;
    for (int i = 0; i <= 255; ++i) EXPECT_NE(map(i / 255.0), nan_color) << map.name;
    EXPECT_EQ(map(std::numeric_limits<double>::infinity()), map(1)) << map.name;
    EXPECT_EQ(map(-std::numeric_limits<double>::infinity()), map(0)) << map.name;
  }
  geometry::Vertices some = with_scalar({1, nan, 2}), all = with_scalar({nan, nan});
  apply_appearance({ScalarColor{"s", "viridis", {}}, ScalarOpacity{"s", {0.25, 1}, {}}, "s"}, some);
  EXPECT_EQ(rgb(some.colors[1]), nan_color);
  EXPECT_EQ(some.colors[1].a, 0.25f);
  EXPECT_EQ(some.importance, (std::vector<float>{0, 0, 1}));
  apply_appearance({ScalarColor{"s", "viridis", {}}, {}, "s"}, all);
  EXPECT_EQ(rgb(all.colors[0]), nan_color);
  EXPECT_EQ(all.importance, (std::vector<float>{0, 0}));
}

TEST(UnitAppearance, ADescendingRangeTurnsTheMapRound) {
  const std::vector<double> values{-1, 0, 1, 2.5, 4, 5};
  geometry::Vertices up = with_scalar(values), down = with_scalar(values);
  apply_appearance(
      {ScalarColor{"s", "viridis", Vec2(0, 4)}, ScalarOpacity{"s", {0, 1}, Vec2(0, 4)}, {}}, up);
  apply_appearance(
      {ScalarColor{"s", "viridis", Vec2(4, 0)}, ScalarOpacity{"s", {1, 0}, Vec2(4, 0)}, {}}, down);
  const ColormapRow& map = find_colormap("viridis");
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Vec3 expected = map(1 - values[i] / 4);
    for (int c = 0; c < 3; ++c) EXPECT_FLOAT_EQ(down.colors[i][c], float(expected[c]));
    EXPECT_EQ(down.colors[i].a, up.colors[i].a);
  }
}

TEST(UnitColormap, FourColoursPartTheRangeInThree) {
  const ColormapRow& map = find_colormap("four-color");
  const Vec3 knots[] = {{0, 0.9, 0.2}, {0.8, 0.8, 0}, {1, 0, 0}, {0.4, 0.6, 0}};
  // A share of the range and a mix round thrice, by half an ulp below 1 each: √3 · 3 · 1.1e-16 for
  // three channels, 6e-16.
  for (int i = 0; i < 4; ++i) EXPECT_LT(glm::length(map(i / 3.0) - knots[i]), 1e-15);
  EXPECT_LT(glm::length(map(0.5) - 0.5 * (knots[1] + knots[2])), 1e-15);
  EXPECT_EQ(map(2), map(1));
}

}  // namespace
}  // namespace pellucid::scene
