// SPDX-License-Identifier: GPL-3.0-or-later
// Opacity optimization by OpenGL against the exact sums, and against the ray tracer with the same
// series.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/error.h"
#include "groundtruth/sums/fourier_sum.h"
#include "scene/opacity_energy.h"
#include "tests/compare/methods/opacity_scenes.h"

namespace pellucid::compare {
namespace {

using namespace testing;

// The transmittance of a pixel is exact in its series (Eq. 18): of sheets it is the product of what
// Eq. 10 makes of the series of the importance, here in double.
TEST(AgreementFourierOpacity, SheetsHaveTheOpacitiesOfTheirSeries) {
  const scene::EnergyWeights weights{1, 3, 2, 1.5};
  for (const auto& [bands, middle, per] : {std::tuple(1, true, "element"),
                                           {5, false, "element"},
                                           {5, true, "fragment"},
                                           {20, false, "fragment"}}) {
    const Sheets sheets = important_sheets(7, 3);
    groundtruth::FourierSum series(bands);
    for (std::size_t i = 0; i < 7; ++i) series.add(sheets.g[i] * sheets.g[i], sheets.d[i]);
    double transmittance = 1;
    for (std::size_t i = 0; i < 7; ++i) {
      const double own = sheets.g[i] * sheets.g[i], sum = series.up_to(sheets.d[i]);
      const double ahead = sum - (middle ? own / 2 : own);
      transmittance *= 1 - 0.5 * scene::optimal_opacity(weights, sheets.g[i], ahead,
                                                        series.up_to(1) - ahead - own);
    }
    const Image image = draw("fourier-opacity", sheets.scene,
                             {{"q", "3"},
                              {"r", "2"},
                              {"lambda", "1.5"},
                              {"bands", "2"},
                              {"per", per},
                              {"at", middle ? "middle" : "behind"},
                              {"importance-bands", std::to_string(bands)}})
                            .image;
    // Waves are off by 5e-7 and their sums of importance, below 1, by about as much; each of four
    // fading opacities takes q, r <= 3 times that, half its own opacity.
    EXPECT_NEAR(image.at(1, 1).a, 1 - transmittance, 3e-6) << bands << middle;
  }
}

/// Triangles, a line and points through each other.
scene::Scene important_shapes() {
  scene::Scene scene;
  scene.width = 90;
  scene.height = 70;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto any = [&] { return Vec3(unit(random), unit(random), unit(random)); };
  scene::LineObject lines;
  lines.radius = 0.07;
  scene::PointObject points;
  points.radius = 0.15;
  for (int k = 0; k < 40; ++k) {
    for (geometry::Vertices* vertices : {static_cast<geometry::Vertices*>(&lines.set),
                                         static_cast<geometry::Vertices*>(&points.set)}) {
      vertices->positions.push_back(any());
      vertices->colors.emplace_back(0.5 + 0.5 * any(), 0.5 + 0.4 * unit(random));
      vertices->importance.push_back(float(0.5 + 0.5 * unit(random)));
    }
  }
  lines.set.offsets = {0, 17, 18, 40};
  scene.objects = {{"mesh", random_triangles(30, 7, 1)}, {"lines", lines}, {"points", points}};
  geometry::Vertices& mesh = scene.objects[0].vertices();
  for (const Rgba& color : mesh.colors) mesh.importance.push_back(color.r * color.r);
  return scene;
}

TEST(AgreementFourierOpacity, TheRayTracerWithTheSameSeriesHasTheSameOpacities) {
  const scene::Scene scene = important_shapes();
  RawOptions options = {{"bands", "5"}, {"q", "20"}, {"r", "5"}};
  const scene::Rendering truth = draw("decoupled", scene, options);
  options["per"] = "fragment";
  const scene::Rendering test = draw("fourier-opacity", scene, options);
  std::size_t compared = 0;
  for (std::size_t i = 0; i < truth.image.pixels.size(); ++i) {
    if (truth.layers.pixels[i] != test.layers.pixels[i]) continue;
    ++compared;
    // The roundings of the series are some 1e-6, and count q-fold.
    EXPECT_NEAR(truth.image.pixels[i].a, test.image.pixels[i].a, 1e-4);
  }
  EXPECT_GT(compared, truth.image.pixels.size() * 95 / 100);
}

TEST(UnitFourierOpacity, WhereNothingFadesItIsTheFourierMethod) {
  scene::Scene scene = important_shapes();
  const Image plain = draw("fourier", scene).image;
  const auto expect_plain = [&](const RawOptions& options) {
    // The weights of an element's vertex add up to 1 but for roundings.
    EXPECT_LE(largest_difference(draw("fourier-opacity", scene, options).image, plain), 1e-5);
  };
  expect_plain({{"q", "0"}, {"r", "0"}});
  for (const float g : {1.0f, 0.0f}) {
    for (scene::SceneObject& object : scene.objects)
      object.vertices().importance.assign(object.vertices().positions.size(), g);
    expect_plain({{"q", "1e12"}, {"r", "1e12"}});
  }
  for (scene::SceneObject& object : scene.objects) object.vertices().importance.clear();
  expect_plain({});
}

/// Lines as ribbons and as tubes, points as discs and as spheres.
scene::Scene shapes_of_importance(float g) {
  scene::Scene scene = important_shapes();
  auto tubes = std::get<scene::LineObject>(scene.objects[1].shape);
  tubes.profile = scene::LineObject::Profile::tube;
  auto spheres = std::get<scene::PointObject>(scene.objects[2].shape);
  spheres.profile = scene::PointObject::Profile::sphere;
  scene.objects.push_back({"tubes", tubes});
  scene.objects.push_back({"spheres", spheres});
  for (scene::SceneObject& object : scene.objects)
    object.vertices().importance.assign(object.vertices().positions.size(), g);
  return scene;
}

/// What a rasterizer interpolates of a constant 1 is off by a rounding of 6e-8. Weights of 1e12
/// made 6e4 of it.
TEST(UnitOpacity, ConstantImportanceIsThatConstantInEveryPixel) {
  const RawOptions weights = {{"q", "1e12"}, {"r", "1e12"}, {"lambda", "0.5"}, {"per", "fragment"}};
  RawOptions by_lists = weights;
  by_lists["transmittance"] = "lists";
  for (const float g : {1.0f, 0.0f}) {
    const scene::Scene scene = shapes_of_importance(g);
    const Image plain = draw("linked-list", scene).image;
    EXPECT_EQ(largest_difference(draw("decoupled-lists", scene, weights).image, plain), 0) << g;
    EXPECT_EQ(largest_difference(draw("fourier-opacity", scene, by_lists).image, plain), 0) << g;
    EXPECT_EQ(largest_difference(draw("fourier-opacity", scene, weights).image,
                                 draw("fourier", scene).image),
              0)
        << g;
  }
}

// In front of a context sheet that hides the right half, whatever it is called.
TEST(PropertyOpacity, OpaqueObjectsAreOfNoImportanceToAnyRow) {
  scene::Scene scene = important_sheets(5, 7).scene;
  scene.objects.push_back({"context", rectangle(0, 2, -2, 2, 0.3, Rgba(0, 1, 0, 1)), true});
  for (const scene::MethodRow& row : methods()) {
    if (!row.promises.optimizes_opacity) continue;
    Image pictures[2];
    for (const int g : {0, 1}) {
      scene.objects.back().vertices().importance.assign(4, float(g));
      pictures[g] = draw(row.name, scene, {{"q", "50"}, {"r", "100"}}).image;
    }
    EXPECT_EQ(largest_difference(pictures[0], pictures[1]), 0) << row.name;
  }
}

TEST(PropertyFourierOpacity, ExtremeWeightsGiveFinitePictures) {
  const scene::Scene scene = important_shapes();
  for (const char* q : {"0", "1e12"})
    for (const char* lambda : {"0", "100"}) {
      const Image image =
          draw("fourier-opacity", scene, {{"q", q}, {"r", q}, {"lambda", lambda}}).image;
      for (const Rgba& pixel : image.pixels)
        for (int c = 0; c < 4; ++c)
          EXPECT_TRUE(pixel[c] >= 0 && pixel[c] <= 1.00001f) << q << lambda;
    }
}

TEST(PropertyFourierOpacity, ASceneBehindTheCameraIsAnError) {
  scene::Scene scene = important_shapes();
  scene.camera.target = 2.0 * scene.camera.eye - scene.camera.target;
  EXPECT_THROW(draw("fourier-opacity", scene), InputError);
}

}  // namespace
}  // namespace pellucid::compare
