// SPDX-License-Identifier: GPL-3.0-or-later
// Stacks of sheets, whose composite is known exactly, in every method.
#include <gtest/gtest.h>

#include "tests/oit/oit_pictures.h"

namespace pellucid::oit {
namespace {

using namespace testing;

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

}  // namespace
}  // namespace pellucid::oit
