// Closed forms: stacks of sheets, whose composite is known exactly.
#include <gtest/gtest.h>

#include "tests/oit/test_scenes.h"

namespace pellucid::test {
namespace {

TEST(UnitMethods, OneLayerIsTheTruthInEveryMethod) {
  for (const MethodRow& row : oit_methods())
    for (const float alpha : {0.0f, 1e-8f, 0.3f, 0.9999f, 1 - 1e-7f, 1.0f}) {
      SCOPED_TRACE(std::string(row.name) + " alpha " + std::to_string(alpha));
      const std::vector<Rgba> layers = {{0.9f, 0.2f, 0.4f, alpha}};
      const Scene scene = stack(5, 3, layers);
      const Rendering rendering = render(row, scene);
      // 1e-4 of opacity is what the clamp at 0.9999 takes off an opaque layer.
      EXPECT_LE(max_difference(rendering.image, composite(layers, scene.background)), 1.001e-4);
    }
}

TEST(UnitMethods, ExactMethodsCompositeAStack) {
  for (const MethodRow& row : oit_methods()) {
    if (!row.promises.exact) continue;
    // Both sides of every limit at which the lists are sorted in another way.
    for (const int n : {2, 7, 16, 17, 33, 100, 1000, 1024, 1025}) {
      SCOPED_TRACE(std::string(row.name) + " layers " + std::to_string(n));
      const auto layers = random_layers(n, n < 100 ? 1.0f : 10.0f / float(n), 1);
      const Scene scene = stack(7, 5, layers);
      const Rendering rendering = render(row, scene, {}, true);
      EXPECT_EQ(rendering.stats.max_layers, unsigned(n));
      EXPECT_EQ(rendering.stats.fragments, std::uint64_t(n) * 35);
      EXPECT_EQ(rendering.stats.dropped, 0u);
      // n roundings of 6e-8 each, of which most cancel.
      EXPECT_LE(max_difference(rendering.image, composite(layers, scene.background)), 1e-5);
    }
  }
}

TEST(UnitMethods, CoincidentLayersAreOrderedByObject) {
  for (const MethodRow& row : oit_methods()) {
    if (!row.promises.exact) continue;
    SCOPED_TRACE(row.name);
    const auto layers = random_layers(20, 0.5f, 2);
    Scene scene = empty_scene(3, 3);
    for (const Rgba& layer : layers) scene.objects.push_back(sheet(0, layer));
    const Rendering rendering = render(row, scene);
    EXPECT_LE(max_difference(rendering.image, composite(layers, scene.background)), 1e-5);
  }
}

TEST(UnitMethods, SliversOfDepthAreToldApart) {
  for (const MethodRow& row : oit_methods()) {
    if (!row.promises.exact) continue;
    SCOPED_TRACE(row.name);
    // A millionth of their distance apart, about one ulp of a float world depth.
    const std::vector<Rgba> layers = {{1, 0, 0, 0.5f}, {0, 1, 0, 0.5f}};
    Scene scene = empty_scene(3, 3);
    scene.camera.eye.z = 1;
    scene.objects = {sheet(0.25, layers[1]), sheet(0.25 + 1e-6, layers[0])};
    const Rendering rendering = render(row, scene);
    EXPECT_LE(max_difference(rendering.image, composite(layers, scene.background)), 1e-5);
  }
}

TEST(UnitMethods, LayersOfOneColourAndOpacityAreTheTruthForAverages) {
  const std::vector<Rgba> layers(12, Rgba(0.3f, 0.6f, 0.2f, 0.25f));
  const Scene scene = stack(4, 4, layers);
  for (const char* name : {"weighted-average", "weighted-blended", "fourier"}) {
    const Rendering rendering = render(method(name), scene);
    EXPECT_LE(max_difference(rendering.image, composite(layers, scene.background)), 1e-5) << name;
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
  const Scene scene = stack(2, 2, layers);
  const glm::dvec4 expected(
      (1 - transmittance) * colors / opacities + transmittance * scene.background,
      1 - transmittance);
  EXPECT_LE(max_difference(render(method("weighted-average"), scene).image, expected), 1e-5);
}

// The ends of the depth range, where a Fourier series is periodic: the margin of the range keeps
// the nearest layer in front of the farthest.
TEST(UnitMethods, FourierTellsTheNearestFromTheFarthest) {
  const std::vector<Rgba> layers = {{1, 0, 0, 0.9f}, {0, 1, 0, 0.9f}};
  const Scene scene = stack(2, 2, layers);
  const Rendering rendering = render(method("fourier"), scene, {{"bands", "15"}});
  EXPECT_GT(rendering.image.at(0, 0).r, rendering.image.at(0, 0).g);
}

}  // namespace
}  // namespace pellucid::test
