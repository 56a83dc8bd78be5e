// SPDX-License-Identifier: GPL-3.0-or-later
// Averages within bins of depth, bins from front to back.
#include <gtest/gtest.h>

#include "tests/oit/oit_pictures.h"

namespace pellucid::oit {
namespace {

using namespace testing;

Image by_bins(const scene::Scene& scene, int bins, int per_pass = 25) {
  return render(method("bin-average"), scene,
                {{"bins", std::to_string(bins)}, {"bins-per-pass", std::to_string(per_pass)}})
      .image;
}

/// Sheets of these colours at these z, which lie in [-1, 1] with both ends taken.
scene::Scene sheets(const std::vector<std::pair<double, Rgba>>& list) {
  scene::Scene scene = empty_scene(3, 2);
  for (const auto& [z, color] : list) scene.objects.push_back(sheet(z, color));
  return scene;
}

// Of the mean opacity, and of the mean colour weighted by opacity.
TEST(UnitBinAverage, OneBinIsOneLayerOfTheMeans) {
  const auto layers = random_layers(7, 0.9f, 31);
  Vec3 color(0);
  double alpha = 0;
  for (const Rgba& layer : layers) {
    color += double(layer.a) * Vec3(layer);
    alpha += double(layer.a);
  }
  const scene::Scene scene = stack(3, 2, layers);
  const glm::dvec4 expected(color / 7.0 + (1 - alpha / 7) * scene.background, alpha / 7);
  EXPECT_LE(largest_difference(by_bins(scene, 1), expected), float_composite);
}

// Two bins of z > 0 and z < 0: mean of each, the nearer over the farther.
TEST(UnitBinAverage, BinsAreCompositedFrontToBack) {
  const scene::Scene scene = sheets({{1, {1, 0, 0, 0.2f}},
                                     {0.1, {0, 1, 0, 0.6f}},
                                     {-0.1, {0, 0, 1, 0.5f}},
                                     {-1, {1, 1, 0, 0.3f}}});
  const std::vector<Rgba> means = {{0.25f, 0.75f, 0, 0.4f}, {0.375f, 0.375f, 0.625f, 0.4f}};
  EXPECT_LE(largest_difference(by_bins(scene, 2), composite(means, scene.background)),
            float_composite);
}

TEST(UnitBinAverage, LayersInBinsOfTheirOwnAreExact) {
  const auto layers = random_layers(40, 0.3f, 32);
  const scene::Scene scene = stack(3, 2, layers);
  const glm::dvec4 exact = composite(layers, scene.background);
  EXPECT_LE(largest_difference(by_bins(scene, 200), exact), float_composite);
  EXPECT_GT(largest_difference(by_bins(scene, 20), exact), 0.01);
}

// What makes it a method for samples of a surface: any number of them in a bin are one layer. The
// histogram of optical depth adds them up instead.
TEST(UnitBinAverage, SamplesOfALayerDoNotSaturate) {
  const Rgba color(0.8f, 0.3f, 0.1f, 0.4f);
  std::vector<std::pair<double, Rgba>> samples = {{1, color}, {-1, color}};
  for (int i = 0; i < 500; ++i) samples.emplace_back(0.5 + 1e-4 * i / 500, color);
  const scene::Scene scene = sheets(samples);
  const glm::dvec4 layers = composite({color, color, color}, scene.background);
  EXPECT_LE(largest_difference(by_bins(scene, 10), layers), float_composite);
  const Image histogram = render(method("binning"), scene, {{"bins", "10"}}).image;
  EXPECT_GT(largest_difference(histogram, layers), 0.2);
}

TEST(UnitBinAverage, AFragmentWithoutOpacityGivesNoColour) {
  const scene::Scene scene = sheets({{1, {1, 0, 0, 0.4f}}, {-1, {0, 1, 0, 0}}});
  const std::vector<Rgba> mean = {{1, 0, 0, 0.2f}};
  EXPECT_LE(largest_difference(by_bins(scene, 1), composite(mean, scene.background)),
            float_composite);
}

// Passes of any size, one that does not divide the bins among them, and more than there are.
TEST(PropertyBinAverage, PassesChangeTheMemoryAndNotThePicture) {
  const scene::Scene scene = stack(5, 4, random_layers(300, 0.1f, 33));
  const Image one_pass = by_bins(scene, 100, 100);
  for (const int per_pass : {1, 7, 50, 99, 1000}) {
    // The transmittance in front of a pass is 1 - A of what lies there: some roundings more.
    EXPECT_LE(largest_difference(by_bins(scene, 100, per_pass), one_pass), 1e-6) << per_pass;
    const RawOptions options = {{"bins", "100"}, {"bins-per-pass", std::to_string(per_pass)}};
    EXPECT_EQ(render(method("bin-average"), scene, options).stats.total_bytes(),
              20u * (20 * unsigned(std::min(per_pass, 100)) + 20));
  }
}

}  // namespace
}  // namespace pellucid::oit
