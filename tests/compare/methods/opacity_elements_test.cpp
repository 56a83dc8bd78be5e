// SPDX-License-Identifier: GPL-3.0-or-later
// Opacity optimization in object space: the least opacity of an element, and the same of exact sums
// and of their series.

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/compare/methods/opacity_scenes.h"
#include "tests/compare/methods/promise_scenes.h"

namespace pellucid::compare {
namespace {

using namespace testing;

// A sheet's opacity is the same all over it, and sheets do not hang together: neither the least of
// an element nor smoothing changes it. 40 layers are more than registers sort.
TEST(AgreementDecoupledLists, SheetsAreThoseOfTheRayTracer) {
  for (const int n : {3, 16, 40}) {
    const scene::Scene scene = important_sheets(n, 4).scene;
    const RawOptions weights = {{"q", "3"}, {"r", "2"}, {"lambda", "1.5"}};
    // Some n roundings of sums of importance, up to n / 4, three times; then those of compositing.
    EXPECT_LE(largest_difference(draw("decoupled", scene, weights).image,
                                 draw("decoupled-lists", scene, weights).image),
              1e-5)
        << n;
  }
}

// Of registers, of one pass of sorting, and of a pass for each level of a merge sort.
TEST(AgreementDecoupledLists, FragmentsAreThoseOfTheRayTracer) {
  for (const int n : {3, 16, 40, 5000}) {
    const scene::Scene scene = important_sheets(n, 4).scene;
    const RawOptions weights = {{"q", "3"}, {"r", "2"}, {"lambda", "1.5"}};
    RawOptions fragments = weights;
    fragments["per"] = "fragment";
    // n roundings of sums of importance, up to n / 4: their relative error is n 6e-8 at most, some
    // √n 6e-8 as a rule.
    EXPECT_LE(largest_difference(draw("decoupled", scene, weights).image,
                                 draw("decoupled-lists", scene, fragments).image),
              1e-5)
        << n;
  }
}

// Fragments of one triangle have opacities of their own. Pixels at edges may have a layer more or
// less: they are left out, and few. Importance and depth are interpolated in float, to some 1e-6,
// of which weights up to 100 make 1e-4.
TEST(AgreementDecoupledLists, FragmentsOfCrossingTrianglesAreThoseOfTheRayTracer) {
  const scene::Scene scene = with_importance(triangle_cloud(60, 40, 60, 15));
  const scene::Rendering exact = draw("decoupled", scene),
                         lists = draw("decoupled-lists", scene, {{"per", "fragment"}});
  int compared = 0;
  for (std::size_t i = 0; i < exact.image.pixels.size(); ++i) {
    if (exact.layers.pixels[i] != lists.layers.pixels[i]) continue;
    ++compared;
    EXPECT_LE(glm::length(exact.image.pixels[i] - lists.image.pixels[i]), 1e-4f) << i;
  }
  EXPECT_GT(compared, 2300);  // of 2400
}

// Three layers, the middle one important: g = 0, 1, 0 and q = 3, r = 1 make opacities 1/4, 1, 1/2.
TEST(UnitDecoupledLists, ThreeLayersInClosedForm) {
  scene::Scene scene =
      stack(3, 2, 2, [](int i) { return Rgba(i == 0, i == 1, i == 2, i == 1 ? 0.5 : 1); });
  for (scene::SceneObject& object : scene.objects)
    object.vertices().importance.assign(4, object.vertices().colors[0].g);
  scene.energy = {.p = 1, .q = 7, .r = 1, .lambda = 2};
  const Image image = draw("decoupled-lists", scene, {{"q", "3"}}).image;  // r is the scene's
  const Rgba expected(0.25 + 0.1875, 0.375 + 0.1875, 0.1875 + 0.1875, 0.8125);
  EXPECT_LE(glm::length(image.at(1, 1) - expected), 1e-6f);
}

/// An important sheet behind the right half of the picture.
scene::Scene half_important(const scene::SceneObject& in_front) {
  scene::Scene scene = orthographic_scene(16, 16);
  scene.background = Vec3(0);
  geometry::TriangleMesh sheet = rectangle(0, 1.5, -1.5, 1.5, -1, Rgba(0, 0, 1, 1));
  sheet.importance.assign(4, 1);
  scene.objects = {in_front, {"important", sheet}};
  return scene;
}

// q = 3 takes the line's opacity to 1/4 where it is in front of what is important.
TEST(UnitOpacityElements, AnElementHasTheLeastOpacityOfItsFragments) {
  const scene::Scene scene = half_important({"line", long_line(0.4, 1)});
  const auto left = [&](const char* method, const char* segments, const char* smooth, int x) {
    return draw(method, scene, {{"q", "3"}, {"r", "0"}, {"segments", segments}, {"smooth", smooth}})
        .image.at(x, 8)
        .a;
  };
  EXPECT_NEAR(left("decoupled-lists", "1", "0", 1), 0.25, 1e-6);  // one element: all of it fades
  EXPECT_NEAR(left("decoupled-lists", "16", "0", 1), 1, 1e-6);   // many: nothing is behind it there
  EXPECT_NEAR(left("decoupled-lists", "16", "0", 10), 1, 1e-6);  // opaque sheet behind
  // Two elements of opacity 1 and 1/4, from middle to middle of each: at pixel 6, 1.5 segments past
  // the middle of the picture's left half, 5/16 of the way.
  EXPECT_NEAR(left("decoupled-lists", "2", "0", 6), 1 - 0.75 * 2.5 / 8, 1e-5);
  // One iteration mixes them half and half: both are 5/8.
  EXPECT_NEAR(left("decoupled-lists", "2", "1", 1), 0.625, 1e-6);
  // Five bands have G(d) = 11 d at the nearest depth, which is 1e-5.
  EXPECT_NEAR(left("fourier-opacity", "1", "0", 1), 0.25, 1e-4);
  EXPECT_NEAR(left("fourier-opacity", "2", "1", 1), 0.625, 1e-4);
}

TEST(UnitOpacityElements, APointIsAnElement) {
  scene::PointObject points;
  points.radius = 0.7;
  points.set.positions = {{-0.1, 0, 1}, {-0.2, 0, 0.9}};
  points.set.colors = {{1, 0, 0, 1}, {0, 1, 0, 0}};
  const scene::Scene scene = half_important({"points", points});
  for (const char* method : {"decoupled-lists", "fourier-opacity"})
    // The series reads importance a little off its step. Measured 2e-5; five times that.
    EXPECT_NEAR(draw(method, scene, {{"q", "3"}, {"r", "0"}}).image.at(3, 8).a, 0.25, 1e-4)
        << method;
}

TEST(UnitOpacityElements, APatchIsAnElement) {
  const scene::Scene scene = half_important({"sheet", full_layer(1, Rgba(1, 0, 0, 1))});
  for (const char* method : {"decoupled-lists", "fourier-opacity"})
    // As of a point.
    EXPECT_NEAR(draw(method, scene, {{"q", "3"}, {"r", "0"}, {"patches", "1"}}).image.at(3, 8).a,
                0.25, 1e-4)
        << method;
}

std::uint64_t importance_bytes(const scene::Rendering& rendering) {
  for (const scene::NamedBytes& part : rendering.stats.bytes)
    if (part.name.find("importance") != std::string::npos) return part.bytes;
  return 0;
}

// Where all pixels have the same layers, so have those of half the resolution: odd sizes, context
// that hides one half of the layers, and samples of a pixel included.
TEST(PropertyFourierOpacity, HalfTheResolutionOfTheImportanceIsEnoughForSheets) {
  for (const auto& [width, height] : {std::pair(8, 6), {7, 5}, {1, 1}})
    for (const int samples : {1, 2}) {
      scene::Scene scene = important_sheets(8, 5).scene;
      scene.width = width;
      scene.height = height;
      scene.samples.per_axis = samples;
      scene.objects[4].opaque = true;
      const RawOptions full = {{"q", "20"}, {"r", "10"}, {"lambda", "1.5"}};
      RawOptions half = full;
      half["importance-resolution"] = "half";
      const scene::Rendering whole = draw("fourier-opacity", scene, full);
      const scene::Rendering quarter = draw("fourier-opacity", scene, half);
      // The sums of both add the same numbers in the same order.
      EXPECT_LE(largest_difference(whole.image, quarter.image), 1e-6) << width << ' ' << samples;
      const std::uint64_t pixels = std::uint64_t((width + 1) / 2) * ((height + 1) / 2);
      EXPECT_EQ(importance_bytes(quarter) * std::uint64_t(width) * std::uint64_t(height),
                importance_bytes(whole) * pixels);
    }
}

// The sheet begins between two blocks of 2 x 2 pixels: each block has one importance.
TEST(PropertyFourierOpacity, HalfTheResolutionOfTheImportanceKeepsItsPlace) {
  const scene::Scene scene = half_important({"line", long_line(0.4, 1)});
  const RawOptions full = {{"smooth", "0"}, {"q", "5"}};
  RawOptions half = full;
  half["importance-resolution"] = "half";
  // The sums of both add the same numbers in the same order.
  EXPECT_LE(largest_difference(draw("fourier-opacity", scene, full).image,
                               draw("fourier-opacity", scene, half).image),
            1e-6);
}

// Of the important sheet behind the right half, G(1) is 1 there and 0 elsewhere, in the last row
// too.
TEST(UnitFourierOpacity, ASeriesIsReadWhereItsPixelIs) {
  const scene::Scene scene = half_important({"line", long_line(0.4, 1)});
  const scene::MethodRow& row = find_row("method", "fourier-opacity", methods());
  for (const char* resolution : {"full", "half"}) {
    const Parameters parameters(row.name, row.parameters, {{"importance-resolution", resolution}});
    const auto renderer = row.make(scene, parameters, {});
    renderer->render({});
    const double end[] = {1};
    for (const auto& [x, y] : {std::pair(2, 8), {13, 8}, {2, 15}, {13, 15}})
      // The whole sum is exact in a series (Eq. 7), up to a few roundings of waves near 1.
      EXPECT_NEAR(renderer->ray_series(scene::RaySum::importance, x, y, end)->values[0], x > 8,
                  1e-5)
          << resolution << ' ' << x << ' ' << y;
  }
}

}  // namespace
}  // namespace pellucid::compare
