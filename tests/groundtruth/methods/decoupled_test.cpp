// SPDX-License-Identifier: GPL-3.0-or-later
// Opacity optimization: the closed form against minimization, pictures against closed forms, and
// the Fourier series against the bound that it must keep.

#include "groundtruth/methods/decoupled.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "groundtruth/methods/raytrace.h"
#include "groundtruth/sums/fourier_sum.h"
#include "groundtruth/sums/ray_sums.h"
#include "scene/opacity_energy.h"
#include "tests/support/pictures.h"
#include "tests/support/scenes.h"

namespace pellucid::groundtruth {
namespace {

using namespace testing;

Image draw(const scene::MethodRow& row, const scene::Scene& scene, const RawOptions& options = {}) {
  return render(row, scene, options).image;
}

/// Golden-section search: the energy is a parabola in alpha.
double minimized(const scene::EnergyWeights& w, double g, double front, double behind) {
  double low = 0, high = 1;
  while (high - low > 1e-9) {
    const double a = high - (high - low) / std::numbers::phi;
    const double b = low + (high - low) / std::numbers::phi;
    (scene::energy(w, a, g, front, behind) < scene::energy(w, b, g, front, behind) ? high : low) =
        scene::energy(w, a, g, front, behind) < scene::energy(w, b, g, front, behind) ? b : a;
  }
  return (low + high) / 2;
}

TEST(UnitEnergy, TheClosedFormIsTheMinimum) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 500; ++i) {
    const scene::EnergyWeights w{0.1 + unit(random), 100 * unit(random), 100 * unit(random),
                                 4 * unit(random)};
    const double g = unit(random), front = 3 * unit(random), behind = 3 * unit(random);
    // Near its minimum a parabola is flat: doubles tell values of alpha apart by 1e-8 at best.
    EXPECT_NEAR(scene::optimal_opacity(w, g, front, behind), minimized(w, g, front, behind), 1e-6);
  }
}

TEST(UnitEnergy, Limits) {
  EXPECT_EQ(scene::optimal_opacity({1, 1e12, 1e12, 2}, 1, 5, 5), 1);  // what is important stays
  EXPECT_EQ(scene::optimal_opacity({1, 0, 0, 2}, 0, 5, 5), 1);        // no weights: nothing fades
  EXPECT_EQ(scene::optimal_opacity({1, 1e12, 0, 2}, 0, 5, 0), 1);     // q: only of what lies behind
  EXPECT_EQ(scene::optimal_opacity({1, 0, 1e12, 2}, 0, 0, 5), 1);  // r: only of what lies in front
  EXPECT_NEAR(scene::optimal_opacity({1, 1e12, 0, 2}, 0, 0, 1), 1e-12, 1e-20);
  EXPECT_EQ(scene::optimal_opacity({1, 3, 0, 0}, 0.9, 0, 1),
            0.25);  // lambda 0: g itself does not matter
  EXPECT_EQ(scene::optimal_opacity({1, 3, 3, 100}, 0.9, 1, 1),
            1);                                                   // lambda 100: (1 - g) is almost 0
  EXPECT_EQ(scene::optimal_opacity({1, 3, 3, 1}, 0, -1, -1), 1);  // a series may fall below 0
  EXPECT_EQ(scene::optimal_opacity({1, 1, 1, 0.3}, 1 + 2.3e-16, 5, 5),
            1);  // rounding, no root of -0
}

TEST(UnitFourierSum, KeepsTheBoundOfItsRemainder) {
  for (const int bands : {1, 5, 15, 64})
    for (const double at : {0.1, 0.5, 0.83}) {
      FourierSum sum(bands);
      sum.add(2, at);
      // Of 64 bands' terms, at most 2 / (π k) each, roundings of 2.2e-16 and of sines of 2π k,
      // 2.4e-16 k, remain.
      EXPECT_NEAR(sum.up_to(0), 0, 1e-14);
      EXPECT_NEAR(sum.up_to(1), 2, 1e-13);  // Eq. 7
      for (int i = 1; i < 100; ++i) {
        const double d = i / 100.0;
        if (std::abs(d - at) < 1e-9) continue;
        const double bound = 2 / (std::numbers::pi * (bands + 1)) *
                             (1 / std::abs(std::sin(std::numbers::pi * (d - at))) +
                              1 / std::sin(std::numbers::pi * at));
        EXPECT_LE(std::abs(sum.up_to(d) - (d > at ? 2 : 0)), bound) << bands << ' ' << at;
      }
    }
}

// At an impulse itself the remainder is that of one sum alone, and the limit is half the step.
TEST(UnitFourierSum, ConvergesToTheMiddleOfAStep) {
  for (const int bands : {1, 5, 15, 64})
    for (const double at : {0.1, 0.3, 0.83}) {
      FourierSum sum(bands);
      sum.add(2, at);
      EXPECT_LE(std::abs(sum.up_to(at) - 1),
                2 / (std::numbers::pi * (bands + 1) * std::sin(std::numbers::pi * at)))
          << bands << ' ' << at;
    }
}

// Three layers, the middle one important: g = 0, 1, 0 and q = 3, r = 1 make opacities 1/4, 1, 1/2.
TEST(UnitDecoupled, ThreeLayersInClosedForm) {
  for (const std::uint32_t shuffle : {0u, 3u, 4u}) {
    scene::Scene scene = stack(
        3, 2, 2, [](int i) { return Rgba(i == 0, i == 1, i == 2, 1); }, shuffle);
    for (scene::SceneObject& object : scene.objects)
      object.vertices().importance.assign(4, object.vertices().colors[0].g);
    const RawOptions weights = {{"q", "3"}, {"r", "1"}};
    const Image image = draw(decoupled_method(), scene, weights);
    EXPECT_EQ(image.at(0, 0), Rgba(0.25f, 0.75f, 0, 1));
    // From behind the important one is still unobstructed; half its opacity shows the last.
    for (scene::SceneObject& object : scene.objects)
      if (object.vertices().importance[0] == 1)
        for (Rgba& color : object.vertices().colors) color.a = 0.5;
    // Sums in double, rounded to float once in each of four channels.
    EXPECT_LE(glm::length(draw(decoupled_method(), scene, weights).at(1, 1) -
                          Rgba(0.25 + 0.1875, 0.375 + 0.1875, 0.1875 + 0.1875, 0.8125)),
              2 * 6e-8f);
  }
}

// A black opaque layer covers x < 1/16 of a picture of 3 × 3 pixels: of the middle pixel, 2/3 wide,
// the leftmost 5 of 8 columns of samples, which lie 1/12 apart. Behind it, all over the picture, is
// an important blue one, in front of it and of no importance a red one, whose opacity is 1 / (1 +
// q) times its own, 1: a quarter.
TEST(UnitDecoupled, SamplesAreAveraged) {
  scene::Scene scene = orthographic_scene(3, 3);
  scene.samples.per_axis = 8;
  scene.objects = {sheet(1, Rgba(1, 0, 0, 1)),
                   {"", rectangle(-2, 1.0 / 16, -2, 2, 0, Rgba(0, 0, 0, 1))},
                   sheet(-1, Rgba(0, 0, 1, 1))};
  scene.objects[1].opaque = true;
  for (scene::SceneObject& object : scene.objects)
    object.vertices().importance.assign(4, object.opaque ? 0 : object.vertices().colors[0].b);
  const scene::Rendering rendering =
      render(decoupled_method(), scene, {{"q", "3"}, {"r", "0"}}, true);
  // Behind the opaque layer nothing is important, and the red one keeps its opacity.
  const Rgba shown(0.625f + 0.375f * 0.25f, 0, 0.375f * 0.75f, 1);
  // A rounding of the mean to float; the sums are in double.
  EXPECT_LE(glm::length(rendering.image.at(1, 1) - shown), 6e-8f);
  EXPECT_EQ(rendering.layers.at(1, 1), 2u);
  EXPECT_EQ(rendering.stats.fragments, 9u * 64u * 2u);
  EXPECT_EQ(rendering.stats.stored, rendering.stats.fragments);
}

// Sums over a row's layers, at least: its pixels have eight each.
TEST(UnitDecoupled, CountsTheBytesOfARow) {
  const auto bytes = [](int width) {
    const scene::Scene scene = stack(8, width, 2, [](int) { return Rgba(1, 0, 0, 0.5f); });
    return render(decoupled_method(), scene).stats.bytes.at(1);
  };
  EXPECT_EQ(bytes(5).name, "crossings of a row");
  EXPECT_EQ(bytes(5).bytes, 5 * (sizeof(RaySums) + 8 * sizeof(RayLayer)));
  EXPECT_EQ(bytes(10).bytes, 2 * bytes(5).bytes);
}

scene::Scene important_triangles() {
  scene::Scene scene = orthographic_scene(24, 24);
  scene.objects = {{"", random_triangles(60, 3)}};
  geometry::Vertices& vertices = scene.objects[0].vertices();
  for (const Rgba& color : vertices.colors) vertices.importance.push_back(color.r * color.r);
  return scene;
}

TEST(PropertyDecoupled, WithoutImportanceItIsTheExactComposite) {
  scene::Scene scene = important_triangles();
  for (const float g : {0.0f, 1.0f})
    for (const char* lambda : {"0.3", "2"}) {  // 1 - g has a power of 0.6 only if it is not below 0
      scene.objects[0].vertices().importance.assign(180, g);
      EXPECT_EQ(largest_difference(draw(decoupled_method(), scene, {{"lambda", lambda}}),
                                   draw(raytrace_method(), scene)),
                0);
    }
  scene.objects[0].vertices().importance.clear();
  for (const char* bands : {"0", "5"})
    EXPECT_EQ(largest_difference(draw(decoupled_method(), scene, {{"bands", bands}}),
                                 draw(raytrace_method(), scene)),
              0);
}

TEST(PropertyDecoupled, ExtremeWeightsGiveFinitePictures) {
  const scene::Scene scene = important_triangles();
  for (const char* q : {"0", "1e12"})
    for (const char* lambda : {"0", "100"})
      for (const char* bands : {"0", "1", "64"}) {
        const Image image = draw(decoupled_method(), scene,
                                 {{"q", q}, {"r", q}, {"lambda", lambda}, {"bands", bands}});
        for (const Rgba& pixel : image.pixels)
          for (int c = 0; c < 4; ++c) EXPECT_TRUE(pixel[c] >= 0 && pixel[c] <= 1) << q << lambda;
      }
}

}  // namespace
}  // namespace pellucid::groundtruth
