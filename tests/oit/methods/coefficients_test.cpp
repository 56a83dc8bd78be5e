// SPDX-License-Identifier: GPL-3.0-or-later
// Bins, moments and Fourier series of the optical depth.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/oit/oit_pictures.h"

namespace pellucid::oit {
namespace {

using namespace testing;

// Layers in bins of their own, read at the far edge, have the exact optical depth.
TEST(UnitMethods, BinsOfOneLayerEachAreExact) {
  const auto layers = random_layers(10, 0.9f, 6);
  const scene::Scene scene = stack(2, 2, layers);
  const scene::Rendering rendering =
      render(method("binning"), scene, {{"bins", "1024"}, {"mode", "constant"}});
  EXPECT_LE(largest_difference(rendering.image, composite(layers, scene.background)),
            float_composite);
}

// With one bin every layer has the same transmittance in front of it.
TEST(UnitMethods, OneBinIsAnAverage) {
  const std::vector<Rgba> layers = {{1, 0, 0, 0.5f}, {0, 1, 0, 0.5f}};
  const scene::Scene scene = stack(1, 1, layers);
  const glm::dvec4 expected(0.375 + 0.25 * 0.1, 0.375 + 0.25 * 0.5, 0.25 * 0.9, 0.75);
  const RawOptions options = {{"bins", "1"}, {"mode", "constant"}};
  EXPECT_LE(largest_difference(render(method("binning"), scene, options).image, expected),
            float_composite);
}

// Within one bin tau grows in proportion to d.
TEST(UnitMethods, ALinearBinIsARamp) {
  const auto layers = random_layers(3, 0.8f, 16);
  double total = 0;
  for (const Rgba& layer : layers) total -= std::log1p(-double(layer.a));
  Vec3 colors(0);
  double weights = 0;
  for (int i = 0; i < 3; ++i) {
    const double a = layers[std::size_t(i)].a, w = a / (1 - a) * std::exp(-0.5 * i * total);
    colors += w * Vec3(layers[std::size_t(i)]);
    weights += w;
  }
  const scene::Scene scene = stack(2, 2, layers);
  const double alpha = 1 - std::exp(-total);
  const glm::dvec4 expected(alpha * colors / weights + (1 - alpha) * scene.background, alpha);
  const RawOptions options = {{"bins", "1"}, {"mode", "linear"}};
  // The depth range is 1e-5 wider than the sheets on either side.
  EXPECT_LE(largest_difference(render(method("binning"), scene, options).image, expected), 1e-4);
}

// Layers from black to white, all but opaque: the nearest is all that is to be seen, the grey of a
// picture tells how deep one sees into the stack. Of hundreds of them the weights differ still.
TEST(UnitMethods, MomentsTellHundredsOfOpaqueLayersApart) {
  for (const int n : {300, 900}) {
    const scene::Scene scene =
        stack(n, 2, 2, [&](int i) { return Rgba(Vec3(double(i) / (n - 1)), 0.9999f); });
    for (const char* basis : {"power", "trigonometric"})
      for (const char* moments : {"4", "6", "8"}) {
        const Image image =
            render(method("moment"), scene, {{"basis", basis}, {"moments", moments}}).image;
        EXPECT_LE(image.at(1, 1).r, 0.15) << n << ' ' << basis << ' ' << moments;
      }
  }
}

TEST(UnitMethods, MomentsOfFewLayersAreExactWithoutTheMassAtZ) {
  const std::vector<Rgba> all = {
      {1, 0, 0, 0.6f}, {0, 1, 0, 0.8f}, {0, 0, 1, 0.5f}, {1, 1, 0, 0.7f}};
  for (const char* basis : {"power", "trigonometric"})
    for (const int n : {2, 3, 4}) {
      const std::vector<Rgba> layers(all.begin(), all.begin() + n);
      const scene::Scene scene = stack(2, 2, layers);
      const RawOptions options = {
          {"overestimation", "0"}, {"moments", std::to_string(2 * n)}, {"basis", basis}};
      // So many moments of n layers leave no choice; the bias and roundings cost the digits.
      EXPECT_LE(largest_difference(render(method("moment"), scene, options).image,
                                   composite(layers, scene.background)),
                2e-2)
          << basis << ' ' << n;
    }
}

// Beyond 15 bands the coefficients take several passes. The margin keeps the steps of the first and
// the last layer apart, which the series takes for neighbours.
TEST(UnitMethods, FourierConvergesThroughManyBands) {
  const auto layers = random_layers(4, 0.8f, 8);
  const scene::Scene scene = stack(2, 2, layers);
  const glm::dvec4 exact = composite(layers, scene.background);
  double previous = 1;
  for (const char* bands : {"1", "15", "64"}) {
    const Image image =
        render(method("fourier"), scene, {{"bands", bands}, {"at", "middle"}, {"margin", "0.2"}})
            .image;
    const double error = largest_difference(image, exact);
    EXPECT_LT(error, previous) << bands;
    previous = error;
  }
  // A series of m bands leaves 1 / (π m) of a step at a distance of a quarter, 0.005 for 64, of
  // which opacities up to 0.8 show the most.
  EXPECT_LT(previous, 5e-3);
}

// Erratum: read behind the step, the series does not converge where opacities differ.
TEST(UnitMethods, FourierAsPublishedHasAFloor) {
  const std::vector<Rgba> layers = {{1, 0, 0, 0.9f}, {0, 1, 0, 0.1f}};
  const scene::Scene scene = stack(2, 2, layers);
  const Image image = render(method("fourier"), scene, {{"bands", "64"}}).image;
  EXPECT_GT(largest_difference(image, composite(layers, scene.background)), 5e-3);
}

TEST(UnitMethods, FourierOfASubsetIsThatOfAllWhenTrianglesRepeat) {
  // Each sheet's triangles twice: every second one is the same scene at half the optical depth.
  const auto layers = random_layers(6, 0.5f, 9);
  scene::Scene scene = stack(4, 4, layers);
  for (scene::SceneObject& object : scene.objects) {
    auto& t = object.mesh().triangles;
    t = {t[0], t[0], t[1], t[1]};
  }
  const Image all = render(method("fourier"), scene).image;
  const Image half = render(method("fourier"), scene, {{"subset", "2"}}).image;
  EXPECT_LE(largest_difference(all, half), float_composite);
}

// The ends of the depth range, where a Fourier series is periodic: the margin of the range keeps
// the nearest layer in front of the farthest.
TEST(UnitMethods, FourierTellsTheNearestFromTheFarthest) {
  const std::vector<Rgba> layers = {{1, 0, 0, 0.9f}, {0, 1, 0, 0.9f}};
  const scene::Scene scene = stack(2, 2, layers);
  const scene::Rendering rendering = render(method("fourier"), scene, {{"bands", "15"}});
  EXPECT_GT(rendering.image.at(0, 0).r, rendering.image.at(0, 0).g);
}

}  // namespace
}  // namespace pellucid::oit
