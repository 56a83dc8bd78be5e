// SPDX-License-Identifier: GPL-3.0-or-later
// The sums along a ray: closed forms of stacks, and the picture itself.

#include "groundtruth/sums/ray_sums.h"

#include <gtest/gtest.h>

#include <limits>

#include "groundtruth/methods/raytrace.h"
#include "tests/support/scenes.h"

namespace pellucid::groundtruth {
namespace {

using namespace testing;

TEST(UnitRaySums, StackInClosedForm) {
  // n layers of α = 1/4 and g = i / n at equal distances, given in any order.
  const int n = 16;
  for (const std::uint32_t shuffle : {0u, 5u}) {
    scene::Scene scene = stack(
        n, 3, 3, [](int i) { return Rgba(float(i) / n, 0, 0, 0.25f); }, shuffle);
    for (scene::SceneObject& object : scene.objects) {
      const geometry::Vertices& vertices = object.vertices();
      object.vertices().importance.assign(4, vertices.colors[0].r);
    }
    const RayProbe probe(scene);
    const RaySums sums = probe.at(1.5, 1.5);
    ASSERT_EQ(sums.layers.size(), std::size_t(n));
    double g_sum = 0;
    for (int i = 0; i < n; ++i) {
      const RayLayer& layer = sums.layers[i];
      const double z = 4 + 2.0 * i / (n - 1);  // from the eye at z = 5
      g_sum += double(i) * i / (n * n);
      // Depths up to 6 and sums up to n take an ulp of 8.9e-16 for each of a few roundings;
      // products of 3/4, and shares, are below 1.
      EXPECT_NEAR(layer.depth, z, 1e-14);
      EXPECT_NEAR(layer.d, probe.depths().normalized(z), 1e-14);
      EXPECT_NEAR(layer.importance, double(i) / n, 1e-15);
      EXPECT_NEAR(layer.transmittance, std::pow(0.75, i), 1e-15);
      EXPECT_NEAR(layer.importance_sum, g_sum, 1e-14);
      EXPECT_NEAR(layer.optical_depth, -(i + 1) * std::log(0.75), 1e-14);
      // The curves are steps at the layers.
      EXPECT_EQ(sums.importance_sum(layer.d), layer.importance_sum);
      EXPECT_EQ(sums.optical_depth(layer.d + 1e-6), layer.optical_depth);
      EXPECT_EQ(sums.optical_depth(layer.d - 1e-6), i ? sums.layers[i - 1].optical_depth : 0);
    }
    EXPECT_EQ(sums.importance_sum(0), 0);
    EXPECT_EQ(sums.optical_depth(1), sums.layers.back().optical_depth);
    // Up to 26 factors of 3/4 are exact in 53 bits: each takes two.
    EXPECT_NEAR(sums.transmittance, std::pow(0.75, n), 1e-16);
  }
}

// Context: it ends the ray, and of what lies in front of it none has to make way.
TEST(UnitRaySums, OpaqueObjectsAreOfNoImportance) {
  scene::Scene scene = stack(3, 3, 3, [](int) { return Rgba(0, 0, 0, 0.25f); });
  for (scene::SceneObject& object : scene.objects) object.vertices().importance.assign(4, 0.5f);
  scene.objects[1].opaque = true;
  const RaySums sums = RayProbe(scene).at(1.5, 1.5);
  ASSERT_EQ(sums.layers.size(), 2u);
  EXPECT_EQ(sums.layers[0].importance, 0.5);
  EXPECT_EQ(sums.layers[1].importance, 0);
  EXPECT_EQ(sums.layers[1].importance_sum, 0.25);
  EXPECT_EQ(sums.importance_sum(1), 0.25);
}

/// Triangles of one opacity and one importance, in a perspective.
scene::Scene constant_triangles(float opacity, float importance) {
  scene::Scene scene;
  scene.width = scene.height = 32;
  scene.objects = {{"", random_triangles(40, 6)}};
  geometry::Vertices& vertices = scene.objects[0].vertices();
  for (Rgba& color : vertices.colors) color.a = opacity;
  vertices.importance.assign(vertices.colors.size(), importance);
  return scene;
}

// Weights sum to 1 but for rounding.
TEST(PropertyRaySums, AConstantStaysThatConstantWhereverARayCrosses) {
  for (const float constant : {0.0f, 0.3f, 1.0f}) {
    const scene::Scene scene = constant_triangles(constant, constant);
    const RayProbe probe(scene);
    for (int y = 0; y < 32; ++y)
      for (int x = 0; x < 32; ++x) {
        const RaySums sums = probe.at(x + 0.5, y + 0.5);
        for (const RayLayer& layer : sums.layers) {
          ASSERT_EQ(layer.opacity, double(constant));
          ASSERT_EQ(layer.importance, double(constant));
        }
        if (constant < 1 || sums.layers.empty()) continue;
        EXPECT_EQ(sums.layers[0].optical_depth, std::numeric_limits<double>::infinity());
        EXPECT_EQ(sums.transmittance, 0);
        EXPECT_EQ(sums.optical_depth(1), std::numeric_limits<double>::infinity());
      }
  }
}

TEST(PropertyRaySums, TransmittanceIsTheExponentialOfOpticalDepth) {
  scene::Scene scene;
  scene.width = scene.height = 16;
  scene.objects = {{"", random_triangles(300, 3)}};
  const RayProbe probe(scene);
  const scene::Rendering picture =
      raytrace_method()
          .make(scene, Parameters("raytrace", raytrace_method().parameters, {}), {})
          ->render({.layers = true});
  std::size_t most = 0;
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) {
      const RaySums sums = probe.at(x + 0.5, y + 0.5);
      most = std::max(most, sums.layers.size());
      // The optical depth of some twenty layers, up to 40, has an ulp of 7e-15, times the
      // transmittance, which is small where the depth is large.
      EXPECT_NEAR(std::exp(-sums.optical_depth(1)), sums.transmittance, 1e-14);
      EXPECT_EQ(picture.image.at(x, y), Rgba(sums.color, 1 - sums.transmittance));
      EXPECT_EQ(picture.layers.at(x, y), sums.layers.size());
      for (const RayLayer& layer : sums.layers) {
        EXPECT_GT(layer.d, 0);
        EXPECT_LT(layer.d, 1);
      }
    }
  EXPECT_GT(most, 10u);
}

}  // namespace
}  // namespace pellucid::groundtruth
