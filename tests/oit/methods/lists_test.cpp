// SPDX-License-Identifier: GPL-3.0-or-later
// Linked lists: no limit on the layers of a pixel.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/oit/oit_pictures.h"

namespace pellucid::oit {
namespace {

using namespace testing;

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

}  // namespace
}  // namespace pellucid::oit
