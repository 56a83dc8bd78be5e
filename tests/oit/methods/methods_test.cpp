// SPDX-License-Identifier: GPL-3.0-or-later
// Closed forms: stacks of sheets, whose composite is known exactly.
#include <gtest/gtest.h>

#include "tests/oit/oit_pictures.h"

namespace pellucid::oit {
namespace {

using namespace testing;

void expect_exact_stack(const scene::MethodRow& row, int n, double tolerance = float_composite) {
  SCOPED_TRACE(std::string(row.name) + " layers " + std::to_string(n));
  auto layers = random_layers(n, n < 100 ? 1.0f : 10.0f / float(n), 1);
  scene::Scene scene = stack(3, 2, layers);
  // Submitted in an order of no meaning; the sheets' depths decide.
  std::shuffle(scene.objects.begin(), scene.objects.end(), std::mt19937(2));
  const scene::Rendering rendering = render(row, scene, {}, true);
  EXPECT_EQ(rendering.stats.max_layers, unsigned(n));
  EXPECT_EQ(rendering.stats.fragments, std::uint64_t(n) * 6);
  EXPECT_EQ(rendering.stats.dropped, 0u);
  // About sqrt(n) roundings of 6e-8 remain of n: 6e-6 for 10^4 layers.
  EXPECT_LE(largest_difference(rendering.image, composite(layers, scene.background)), tolerance);
}

TEST(UnitMethods, OneLayerIsTheTruthInEveryMethod) {
  for (const scene::MethodRow& row : oit_methods())
    for (const float alpha : {0.0f, 1e-8f, 0.3f, 0.9999f, 1 - 1e-7f, 1.0f}) {
      SCOPED_TRACE(std::string(row.name) + " alpha " + std::to_string(alpha));
      const std::vector<Rgba> layers = {{0.9f, 0.2f, 0.4f, alpha}};
      const scene::Scene scene = stack(5, 3, layers);
      const scene::Rendering rendering = render(row, scene);
      // 1e-4 of opacity is what the clamp at 0.9999 takes off an opaque layer.
      EXPECT_LE(largest_difference(rendering.image, composite(layers, scene.background)), 1.001e-4);
    }
}

TEST(UnitMethods, ExactMethodsCompositeAStack) {
  for (const scene::MethodRow& row : oit_methods()) {
    if (!row.promises.exact) continue;
    for (const int n : {2, 7, 16, 17, 33, 100}) expect_exact_stack(row, n);
  }
}

// Both sides of the limit at which deep lists are sorted in passes of their own, and far beyond.
TEST(UnitMethods, LinkedListsHaveNoDepthLimit) {
  for (const int n : {1000, 4096, 4097, 10000}) expect_exact_stack(method("linked-list"), n);
}

// Neighbouring pixels share the loops of a shader: each of these columns has its own depth.
TEST(UnitMethods, LinkedListsOfManyLengthsSideBySide) {
  const int counts[] = {5000, 1, 17, 300, 0, 16, 4096, 40};
  const auto layers = random_layers(5000, 0.002f, 17);
  scene::Scene scene = empty_scene(8, 1);
  scene.camera.height = 1;  // a pixel is one unit wide, the first from -4 to -3
  for (int column = 0; column < 8; ++column)
    for (int i = 0; i < counts[column]; ++i) {
      scene::SceneObject strip = sheet(1 - i / 4000.0, layers[std::size_t(i)]);
      for (Vec3& x : strip.mesh().positions) x.x = column - (x.x < 0 ? 4 : 3);
      scene.objects.push_back(std::move(strip));
    }
  std::shuffle(scene.objects.begin(), scene.objects.end(), std::mt19937(4));
  const scene::Rendering rendering = render(method("linked-list"), scene, {}, true);
  for (int column = 0; column < 8; ++column) {
    EXPECT_EQ(rendering.layers.at(column, 0), unsigned(counts[column]));
    const std::vector<Rgba> seen(layers.begin(), layers.begin() + counts[column]);
    const glm::dvec4 exact = composite(seen, scene.background);
    for (int c = 0; c < 4; ++c)
      EXPECT_NEAR(rendering.image.at(column, 0)[c], exact[c], float_composite) << column;
  }
}

TEST(SlowMethods, LinkedListsSortAHundredThousandLayers) {
  expect_exact_stack(method("linked-list"), 100000, 4e-5);
}

TEST(UnitMethods, CoincidentLayersAreOrderedByObject) {
  for (const scene::MethodRow& row : oit_methods()) {
    if (!row.promises.exact) continue;
    SCOPED_TRACE(row.name);
    const auto layers = random_layers(20, 0.5f, 2);
    scene::Scene scene = empty_scene(3, 3);
    for (const Rgba& layer : layers) scene.objects.push_back(sheet(0, layer));
    const scene::Rendering rendering = render(row, scene);
    EXPECT_LE(largest_difference(rendering.image, composite(layers, scene.background)),
              float_composite);
  }
}

TEST(UnitMethods, SliversOfDepthAreToldApart) {
  for (const scene::MethodRow& row : oit_methods()) {
    if (!row.promises.exact) continue;
    SCOPED_TRACE(row.name);
    // A millionth of their distance apart, about one ulp of a float world depth.
    const std::vector<Rgba> layers = {{1, 0, 0, 0.5f}, {0, 1, 0, 0.5f}};
    scene::Scene scene = empty_scene(3, 3);
    scene.camera.eye.z = 1;
    scene.objects = {sheet(0.25, layers[1]), sheet(0.25 + 1e-6, layers[0])};
    const scene::Rendering rendering = render(row, scene);
    EXPECT_LE(largest_difference(rendering.image, composite(layers, scene.background)),
              float_composite);
  }
}

TEST(UnitMethods, PeelingReportsWhatItsBudgetLeaves) {
  const auto layers = random_layers(9, 0.5f, 4);
  const scene::Scene scene = stack(3, 2, layers);
  const scene::Rendering rendering = render(method("depth-peeling"), scene, {{"peels", "4"}}, true);
  EXPECT_EQ(rendering.stats.fragments, 9u * 6);
  EXPECT_EQ(rendering.stats.stored, 4u * 6);
  EXPECT_EQ(rendering.stats.dropped, 5u * 6);
  EXPECT_EQ(rendering.stats.truncated, 6u);
  const std::vector<Rgba> nearest(layers.begin(), layers.begin() + 4);
  EXPECT_LE(largest_difference(rendering.image, composite(nearest, scene.background)),
            float_composite);
}

// Two layers to a peel: of nine, the third from either side on is left.
TEST(UnitMethods, DualPeelingLeavesTheMiddleToItsBudget) {
  const auto layers = random_layers(9, 0.5f, 4);
  const scene::Scene scene = stack(3, 2, layers);
  const scene::Rendering rendering =
      render(method("dual-depth-peeling"), scene, {{"peels", "2"}}, true);
  EXPECT_EQ(rendering.stats.fragments, 9u * 6);
  EXPECT_EQ(rendering.stats.stored, 4u * 6);
  EXPECT_EQ(rendering.stats.dropped, 5u * 6);
  EXPECT_EQ(rendering.stats.truncated, 6u);
  const std::vector<Rgba> ends = {layers[0], layers[1], layers[7], layers[8]};
  EXPECT_LE(largest_difference(rendering.image, composite(ends, scene.background)),
            float_composite);
}

TEST(UnitMethods, WeightedSumIsItsFormula) {
  const auto layers = random_layers(5, 0.15f, 5);
  Vec3 color(0);
  double opacity = 0;
  for (const Rgba& layer : layers) {
    color += double(layer.a) * Vec3(layer);
    opacity += layer.a;
  }
  const scene::Scene scene = stack(2, 2, layers);
  const glm::dvec4 expected(color + (1 - opacity) * scene.background, opacity);
  // Five sums of products up to 1: ten roundings of 6e-8.
  EXPECT_LE(largest_difference(render(method("weighted-sum"), scene).image, expected), 6e-7);
}

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

TEST(UnitMethods, LayersOfOneColourAndOpacityAreTheTruthForAverages) {
  const std::vector<Rgba> layers(12, Rgba(0.3f, 0.6f, 0.2f, 0.25f));
  const scene::Scene scene = stack(4, 4, layers);
  for (const char* name : {"weighted-average", "weighted-blended", "fourier", "binning"}) {
    const scene::Rendering rendering = render(method(name), scene);
    EXPECT_LE(largest_difference(rendering.image, composite(layers, scene.background)),
              float_composite)
        << name;
  }
}

TEST(UnitMethods, WeightedAverageIsItsFormula) {
  const auto layers = random_layers(9, 0.8f, 3);
  Vec3 colors(0);
  double opacities = 0;
  for (const Rgba& layer : layers) {
    colors += double(layer.a) * Vec3(layer);
    opacities += layer.a;
  }
  const double transmittance = std::pow(1 - opacities / 9, 9);
  const scene::Scene scene = stack(2, 2, layers);
  const glm::dvec4 expected(
      (1 - transmittance) * colors / opacities + transmittance * scene.background,
      1 - transmittance);
  EXPECT_LE(largest_difference(render(method("weighted-average"), scene).image, expected),
            float_composite);
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
