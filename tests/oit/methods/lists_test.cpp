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

/// Rectangles of importances of their own, an opaque one among them, four samples a pixel.
scene::Scene important_rectangles() {
  scene::Scene scene = empty_scene(24, 20);
  scene.samples = {.per_axis = 2};
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 60; ++i) {
    const double x = 1.8 * unit(random) - 1, y = 1.8 * unit(random) - 1;
    scene::SceneObject object = {"", rectangle(x, x + unit(random), y, y + unit(random),
                                               2 * unit(random) - 1, Rgba(0.2, 0.6, 0.8, 0.5))};
    for (std::size_t v = 0; v < object.mesh().positions.size(); ++v)
      object.mesh().importance.push_back(float(unit(random)));
    scene.objects.push_back(std::move(object));
  }
  scene.objects.push_back(sheet(-0.5, Rgba(0.3, 0.5, 0.7, 1)));
  scene.objects.back().opaque = true;
  return scene;
}

// Each band of rows has the whole's fragments, so that the pictures are equal to the last bit, and
// keeps no more of them than it was told.
TEST(PropertyLists, BandsOfRowsGiveThePictureOfTheWhole) {
  const scene::Scene scene = important_rectangles();
  const std::pair<const char*, RawOptions> calls[] = {{"linked-list", {}},
                                                      {"decoupled-lists", {{"per", "element"}}},
                                                      {"decoupled-lists", {{"per", "fragment"}}}};
  for (auto [name, options] : calls) {
    const scene::Rendering whole = render(method(name), scene, options, true);
    for (const char* at_once : {"500", "150"}) {
      SCOPED_TRACE(std::string(name) + " " + at_once);
      options["fragments-per-pass"] = at_once;
      const scene::Rendering banded = render(method(name), scene, options, true);
      EXPECT_EQ(banded.image.pixels, whole.image.pixels);
      EXPECT_EQ(banded.stats.fragments, whole.stats.fragments);
      EXPECT_LT(banded.stats.total_bytes(), whole.stats.total_bytes());
    }
  }
}

TEST(PropertyLists, BandsTakeDeepPixelsAsTheWholeDoes) {
  const auto layers = random_layers(5000, 0.002f, 17);
  const scene::Scene scene = stack(2, 6, layers);
  const Image whole = render(method("linked-list"), scene).image;
  const RawOptions options = {{"fragments-per-pass", "20000"}};
  EXPECT_EQ(render(method("linked-list"), scene, options).image.pixels, whole.pixels);
}

TEST(UnitLists, ARowOfMoreFragmentsThanAreKeptIsRefused) {
  const scene::Scene scene = stack(4, 4, random_layers(5, 0.5f, 1));
  const RawOptions options = {{"fragments-per-pass", "19"}};
  try {
    render(method("linked-list"), scene, options);
    FAIL() << "a row of 20 fragments was drawn";
  } catch (const WorkError& error) {
    EXPECT_STREQ(error.what(),
                 "linked-list: a row of the picture has 20 fragments, but 19 are kept at once; "
                 "draw a narrower picture");
  }
}

TEST(SlowMethods, LinkedListsSortAHundredThousandLayers) {
  expect_exact_stack(method("linked-list"), 100000, 4e-5);
}

}  // namespace
}  // namespace pellucid::oit
