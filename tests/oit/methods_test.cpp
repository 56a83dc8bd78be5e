// Closed forms and properties that every row of the method table has to have.
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
    for (const int n : {2, 7, 16, 17, 33, 100, 1000, 1024, 1025, 10000}) {
      SCOPED_TRACE(std::string(row.name) + " layers " + std::to_string(n));
      const auto layers = random_layers(n, n < 100 ? 1.0f : 10.0f / float(n), 1);
      const Scene scene = stack(7, 5, layers);
      const Rendering rendering = render(row, scene, {}, true);
      EXPECT_EQ(rendering.stats.max_layers, unsigned(n));
      EXPECT_EQ(rendering.stats.fragments, std::uint64_t(n) * 35);
      // n float additions of numbers below 1.
      EXPECT_LE(max_difference(rendering.image, composite(layers, scene.background)), 1e-5);
    }
  }
}

}  // namespace
}  // namespace pellucid::test
