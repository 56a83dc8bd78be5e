// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/appearance/appearance.h"

#include <gtest/gtest.h>

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
