// SPDX-License-Identifier: GPL-3.0-or-later
// Every row of the method table samples a pixel where it promises.
#include <gtest/gtest.h>

#include <array>

#include "compare/methods/methods.h"
#include "scene/view/pixel_samples.h"
#include "tests/compare/methods/promise_scenes.h"

namespace pellucid::compare {
namespace {

using namespace testing;

/// Seen by a camera that has moved by so many pixels to the right and down.
scene::Scene seen_from(scene::Scene scene, const Vec2& pixels) {
  const double size = scene.camera.height / scene.height;
  const Vec3 shift(size * pixels.x, -size * pixels.y, 0);
  scene.camera.eye += shift;
  scene.camera.target += shift;
  return scene;
}

// Sampled at its centre, a pixel of a camera moved by s - 1/2 shows what is at s. All of the scene
// stays in the picture, so that its depths stay what they are.
TEST(PropertySampling, APixelIsTheMeanOfItsSamples) {
  scene::Scene scene = with_importance(triangle_cloud(16, 16, 12, 16));
  scene.camera = empty_scene(16, 16).camera;
  scene.camera.height = 4;  // of triangles from -1.5 to 1.5
  for (const scene::PixelSampling sampling : {scene::PixelSampling{.per_axis = 2}, {.frames = 3}})
    for (const scene::MethodRow& row : methods()) {
      SCOPED_TRACE(std::string(row.name) + ": " + scene::describe(sampling));
      const std::vector<Vec2> samples = scene::pixel_samples(sampling);
      Image mean(16, 16, Rgba(0));
      for (const Vec2& sample : samples) {
        const Image one = render(row, seen_from(scene, sample - 0.5)).image;
        for (std::size_t i = 0; i < one.pixels.size(); ++i)
          mean.pixels[i] += one.pixels[i] / float(samples.size());
      }
      scene::Scene sampled = scene;
      sampled.samples = sampling;
      expect_same(row, mean, render(row, sampled).image);
    }
}

/// By how much p lies to the left of the line from a to b; all in pixels, y down.
double left_of(const Vec2& a, const Vec2& b, const Vec2& p) {
  const Vec2 along = glm::normalize(b - a);
  return along.y * (p.x - a.x) - along.x * (p.y - a.y);
}

// In a picture of 64 × 64 pixels of one unit, of triangles at depths of their own: how many cover a
// pixel's centre is known but for those that have an edge within edge_shift.
TEST(PropertySampling, PixelsAreCoveredWhereTheirCentresLieInside) {
  scene::Scene scene = empty_scene(64, 64);
  scene.camera.height = 64;
  std::mt19937 random(17);
  std::uniform_real_distribution<double> place(-4, 68);
  std::vector<std::array<Vec2, 3>> triangles(40);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    geometry::TriangleMesh mesh;
    for (Vec2& corner : triangles[i]) {
      corner = Vec2(place(random), place(random));
      mesh.positions.emplace_back(corner.x - 32, 32 - corner.y, 0.05 * double(i));
      mesh.normals.emplace_back(0, 0, 1);
      mesh.colors.emplace_back(0.5f);
    }
    mesh.triangles = {{0, 1, 2}};
    scene.objects.push_back({"triangle", mesh});
    if (left_of(triangles[i][0], triangles[i][1], triangles[i][2]) < 0)
      std::swap(triangles[i][1], triangles[i][2]);
  }
  for (const scene::MethodRow& row : methods()) {
    const CountImage layers = render(row, scene, {}, true).layers;
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) {
        std::uint32_t inside = 0, near = 0;
        for (const auto& [a, b, c] : triangles) {
          const Vec2 p(x + 0.5, y + 0.5);
          const double depth = std::min({left_of(a, b, p), left_of(b, c, p), left_of(c, a, p)});
          inside += depth > row.promises.edge_shift;
          near += std::abs(depth) <= row.promises.edge_shift;
        }
        ASSERT_GE(layers.at(x, y), inside) << row.name << ' ' << x << ' ' << y;
        ASSERT_LE(layers.at(x, y), inside + near) << row.name << ' ' << x << ' ' << y;
      }
  }
}

}  // namespace
}  // namespace pellucid::compare
