// SPDX-License-Identifier: GPL-3.0-or-later
// Buffers of a few layers, and stochastic samples of one.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/oit/oit_pictures.h"

namespace pellucid::oit {
namespace {

using namespace testing;

TEST(UnitMethods, BuffersOfLayersAreExactUpToTheirLayers) {
  const auto layers = random_layers(8, 0.9f, 15);
  scene::Scene scene = stack(3, 3, layers);
  std::shuffle(scene.objects.begin(), scene.objects.end(), std::mt19937(3));
  for (const char* name : {"k-buffer", "mlab"}) {
    const Image image = render(method(name), scene, {{"layers", "8"}}).image;
    EXPECT_LE(largest_difference(image, composite(layers, scene.background)), float_composite)
        << name;
  }
}

TEST(UnitMethods, KBufferAveragesItsTail) {
  const std::vector<Rgba> layers = {{1, 0, 0, 0.5f}, {0, 1, 0, 0.25f}, {0, 0, 1, 0.5f}};
  const scene::Scene scene = stack(3, 3, layers);
  const Image image = render(method("k-buffer"), scene, {{"layers", "1"}}).image;
  // The tail: opacities 1/4 and 1/2 weight the colours, 3/8 of the background shine through.
  const std::vector<Rgba> merged = {{1, 0, 0, 0.5f}, {0, 1 / 3.f, 2 / 3.f, 0.625f}};
  EXPECT_LE(largest_difference(image, composite(merged, scene.background)), float_composite);
}

TEST(UnitMethods, KBufferKeepsCoincidentLayers) {
  const std::vector<Rgba> layers = {{1, 0, 0, 0.5f}, {0, 1, 0, 0.5f}, {0, 0, 1, 0.5f}};
  scene::Scene scene = empty_scene(3, 3);
  for (const Rgba& layer : layers) scene.objects.push_back(sheet(0, layer));
  const Image image = render(method("k-buffer"), scene).image;
  // Products of halves are exact; what is taken from 1 rounds once.
  EXPECT_NEAR(image.at(1, 1).a, 0.875, 6e-8);
}

// Merged are then only neighbours, the farther under the nearer.
TEST(UnitMethods, MultiLayerBlendingIsExactFromFrontToBack) {
  const auto layers = random_layers(40, 0.3f, 18);
  const scene::Scene scene = stack(3, 3, layers);
  const Image image = render(method("mlab"), scene, {{"layers", "2"}}).image;
  EXPECT_LE(largest_difference(image, composite(layers, scene.background)), float_composite);
}

// Of four layers in two places: what was merged before a layer between them came stays together.
TEST(UnitMethods, MultiLayerBlendingMergesTheFarthest) {
  const std::vector<Rgba> layers = {
      {1, 0, 0, 0.5f}, {0, 1, 0, 0.25f}, {0, 0, 1, 0.5f}, {1, 1, 0, 0.75f}};
  const auto difference = [&](std::initializer_list<std::size_t> submitted,
                              std::initializer_list<std::size_t> seen) {
    const scene::Scene all = stack(3, 3, layers);
    scene::Scene scene = all;
    for (std::size_t i = 0; i < 4; ++i) scene.objects[i] = all.objects[submitted.begin()[i]];
    std::vector<Rgba> expected;
    for (const std::size_t i : seen) expected.push_back(layers[i]);
    const Image image = render(method("mlab"), scene, {{"layers", "2"}}).image;
    return largest_difference(image, composite(expected, scene.background));
  };
  // Layers 1 and 3 are one at the depth of 1, before layer 2 comes and goes behind them.
  EXPECT_LE(difference({0, 1, 3, 2}, {0, 1, 3, 2}), 1e-6);
  // Layers 2 and 3 are one, behind the others.
  EXPECT_LE(difference({3, 2, 1, 0}, {0, 1, 2, 3}), 1e-6);
  // Layers 1 and 3 are one when layer 0 pushes them back.
  EXPECT_LE(difference({1, 3, 0, 2}, {0, 1, 3, 2}), 1e-6);
}

double variance(const std::vector<double>& values) {
  double mean = 0, squares = 0;
  for (const double value : values) mean += value / double(values.size());
  for (const double value : values) squares += (value - mean) * (value - mean);
  return squares / double(values.size());
}

// Two layers: the mean over pixels nears the truth like 1 / sqrt(samples * pixels).
TEST(UnitMethods, StochasticSamplesConverge) {
  const std::vector<Rgba> layers = {{1, 0, 0, 0.5f}, {0, 1, 0, 0.5f}};
  const scene::Scene scene = stack(32, 32, layers);
  const Image image = render(method("stochastic"), scene, {{"samples", "64"}}).image;
  glm::dvec4 mean(0);
  for (const Rgba& pixel : image.pixels) mean += glm::dvec4(pixel) / 1024.0;
  const glm::dvec4 exact = composite(layers, scene.background);
  // The deviation of a sample is 1/2; six of the mean's are 6 * 0.5 / sqrt(65536) = 0.012.
  for (int c = 0; c < 4; ++c) EXPECT_NEAR(mean[c], exact[c], 0.012);
}

TEST(UnitMethods, ADrawOfStochasticIsThatOfTheNextSeed) {
  const scene::Scene scene = stack(8, 8, {{1, 0, 0, 0.5f}, {0, 1, 0, 0.5f}});
  const auto draw = [&](const char* seed, std::uint32_t number) {
    const scene::MethodRow& row = method("stochastic");
    return row.make(scene, Parameters(row.name, row.parameters, {{"seed", seed}}), {})
        ->render({.draw = number})
        .image;
  };
  EXPECT_EQ(largest_difference(draw("3", 4), draw("7", 0)), 0);
  EXPECT_GT(largest_difference(draw("3", 4), draw("3", 0)), 0);
}

// A sample of two layers of α = 1/2 is red, green, or the average where it hits nothing: red's
// variance is at most 1/4. The mean of k draws of one sample each has a k-th of a draw's, if draws
// are independent: 16 draws over 1024 pixels, whose own variance varies by √(2/1023) = 4 %, six
// times.
TEST(UnitMethods, StochasticDrawsAreIndependent) {
  const scene::Scene scene = stack(32, 32, {{1, 0, 0, 0.5f}, {0, 1, 0, 0.5f}});
  const scene::MethodRow& row = method("stochastic");
  const auto renderer =
      row.make(scene, Parameters(row.name, row.parameters, {{"samples", "1"}}), {});
  constexpr std::uint32_t draws = 16;
  std::vector<double> mean(1024, 0);
  double of_one = 0;
  for (std::uint32_t draw = 0; draw < draws; ++draw) {
    const Image image = renderer->render({.draw = draw}).image;
    std::vector<double> red;
    for (const Rgba& pixel : image.pixels) red.push_back(pixel.r);
    of_one += variance(red) / draws;
    for (std::size_t i = 0; i < red.size(); ++i) mean[i] += red[i] / draws;
  }
  EXPECT_GT(of_one, 0.01);
  EXPECT_NEAR(variance(mean) / (of_one / draws), 1, 0.25);
}

}  // namespace
}  // namespace pellucid::oit
