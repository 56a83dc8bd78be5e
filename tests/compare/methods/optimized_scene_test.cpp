// SPDX-License-Identifier: GPL-3.0-or-later
// Opacity optimization as a stage of its own: what any method composites after it.

#include <gmock/gmock.h>

#include "compare/methods/optimize_opacities.h"
#include "compare/methods/surface_methods.h"
#include "core/error.h"
#include "core/files/output_file.h"
#include "scene/files/scene_file.h"
#include "tests/compare/methods/opacity_scenes.h"
#include "tests/compare/methods/promise_scenes.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::compare {
namespace {

using namespace testing;
using ::testing::HasSubstr;

scene::Scene optimized(scene::Scene scene, const std::string& call) {
  optimize_opacities(*parse_opacities(call), {}, scene);
  return scene;
}

// Three layers, the middle one important: g = 0, 1, 0 and q = 3, r = 1 make opacities 1/4, 1, 1/2,
// by which the layers' own 1, 1/2, 1 are multiplied.
TEST(UnitOptimizedScene, ThreeLayersInClosedForm) {
  scene::Scene scene =
      stack(3, 2, 2, [](int i) { return Rgba(i == 0, i == 1, i == 2, i == 1 ? 0.5 : 1); });
  for (scene::SceneObject& object : scene.objects)
    object.vertices().importance.assign(4, object.vertices().colors[0].g);
  scene.energy = {.p = 1, .q = 7, .r = 1, .lambda = 2};
  const scene::Scene after = optimized(scene, "decoupled-lists:q=3");  // r is the scene's
  const float expected[] = {0.25f, 0.5f, 0.5f};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(after.objects[i].vertices().colors[2].a, expected[i], 1e-6) << i;
    EXPECT_TRUE(after.objects[i].vertices().importance.empty());
  }
  EXPECT_EQ(after.provenance.at("opacities"), "decoupled-lists:q=3");
  const Rgba picture(0.25 + 0.1875, 0.375 + 0.1875, 0.1875 + 0.1875, 0.8125);
  EXPECT_LE(glm::length(draw("raytrace", after).image.at(1, 1) - picture), 1e-6f);
}

/// An important sheet behind the right half of the picture; a line of 16 segments, a point on the
/// left and one on the right in front of it; an opaque sheet behind all.
scene::Scene shapes_of_every_kind() {
  scene::Scene scene = orthographic_scene(16, 16);
  geometry::TriangleMesh sheet = rectangle(0, 1.5, -1.5, 1.5, -1, Rgba(0, 0, 1, 1));
  sheet.importance.assign(4, 1);
  scene::PointObject points;
  points.radius = 0.2;
  points.set.positions = {{-0.6, 0.6, 1}, {0.6, 0.6, 1}};
  points.set.colors.assign(2, {0, 1, 0, 0.8});
  scene.objects = {{"context", full_layer(-2, Rgba(1)), true},
                   {"important", sheet},
                   {"line", long_line(0.2, 0.8f)},
                   {"points", points}};
  return scene;
}

// q = 3 takes to 1/4 what is in front of what is important: numbers that floats hold but for 0.8
// and its parts, 1e-7 each.
TEST(UnitOptimizedScene, VerticesOfEveryKindHaveTheirs) {
  const scene::Scene after =
      optimized(shapes_of_every_kind(), "decoupled-lists:q=3,r=0,segments=2,smooth=0");
  EXPECT_EQ(after.objects[0].vertices().colors[0].a, 1);
  EXPECT_EQ(after.objects[1].vertices().colors[0].a, 1);
  const auto& line = after.objects[2].vertices().colors;
  EXPECT_NEAR(line[0].a, 0.8, 1e-6);   // up to the middle of the first of two elements
  EXPECT_NEAR(line[8].a, 0.5, 1e-6);   // half way between them, (1 + 1/4) / 2
  EXPECT_NEAR(line[16].a, 0.2, 1e-6);  // from the middle of the second one on
  const auto& points = after.objects[3].vertices().colors;
  EXPECT_NEAR(points[0].a, 0.8, 1e-6);
  EXPECT_NEAR(points[1].a, 0.2, 1e-6);
}

// A scene has the products of both opacities at its vertices, the method itself multiplies what it
// has interpolated: halfway along a segment they differ by a quarter of the product of both
// changes.
TEST(UnitOptimizedScene, WhereBothOpacitiesChangeTheMethodDiffersByTheirCovariance) {
  scene::Scene scene = shapes_of_every_kind();
  std::vector<Rgba>& own = scene.objects[2].vertices().colors;
  for (std::size_t i = 0; i < own.size(); ++i) own[i].a = i % 2 ? 0.2f : 1;
  const RawOptions options{{"q", "3"}, {"r", "0"}, {"segments", "2"}, {"smooth", "0"}};
  const Image direct = draw("decoupled-lists", scene, options).image;
  const scene::Scene after = optimized(scene, "decoupled-lists:q=3,r=0,segments=2,smooth=0");
  const Image staged = draw("linked-list", after).image;
  double largest = 0;
  for (int x = 0; x < 16; ++x) {  // a segment each, which hides what is blue behind it
    const auto found = [&](int vertex) {
      const auto i = std::size_t(vertex);
      return after.objects[2].vertices().colors[i].a / own[i].a;
    };
    const float change =
        0.25f * (own[std::size_t(x + 1)].a - own[std::size_t(x)].a) * (found(x + 1) - found(x));
    EXPECT_NEAR(direct.at(x, 8).b - staged.at(x, 8).b, change, 1e-6) << x;
    largest = std::max(largest, double(std::abs(change)));
  }
  EXPECT_GT(largest, 0.01);
}

// What a row composites itself, another one composites after the stage.
TEST(AgreementOptimizedScene, RowsCompositeWhatTheStageFinds) {
  for (const int samples : {1, 2}) {
    scene::Scene scene = with_importance(triangle_cloud(24, 18, 40, 15));
    scene.samples.per_axis = samples;
    if (samples == 1) {
      EXPECT_LE(largest_difference(draw("decoupled-lists", scene).image,
                                   draw("linked-list", optimized(scene, "decoupled-lists")).image),
                float_composite);
      EXPECT_LE(largest_difference(draw("fourier-opacity", scene).image,
                                   draw("fourier", optimized(scene, "fourier-opacity")).image),
                float_composite);
    }
    EXPECT_EQ(optimized(scene, "decoupled-lists").samples.per_axis, samples);
  }
}

TEST(PropertyOptimizedScene, RowsThatPromiseOpacitiesOfVerticesHaveThem) {
  const scene::Scene scene = with_importance(triangle_cloud(24, 18, 40, 15));
  for (const scene::MethodRow& row : methods()) {
    const auto renderer = row.make(scene, Parameters(row.name, row.parameters, {}), {});
    renderer->render({});
    const auto found = renderer->optimized_opacities();
    ASSERT_EQ(found.has_value(), row.promises.optimizes_vertices) << row.name;
    if (!found) continue;
    EXPECT_TRUE(row.promises.optimizes_opacity) << row.name;
    std::size_t vertices = 0;
    for (const scene::SceneObject& object : scene.objects)
      vertices += object.vertices().positions.size();
    EXPECT_EQ(found->of_meshes.size(), vertices) << row.name;
  }
}

/// The square that the flow along y sweeps at z.
std::string swept_square(const std::string& z, const std::string& look) {
  return R"({"surface": {"field": "formula:u=0,v=1,w=0", "duration": 2,
                         "integrator": "hultquist:threshold=0.05",
                         "seed": {"from": [-1, -1, )" +
         z + R"(], "to": [1, -1, )" + z + R"(]}}, "opacity": 0.9, )" + look + "}";
}

/// A red square, and in a picture of 32 × 32 pixels behind it a blue one, if any, whose importance
/// grows from 0 at x = -1 to 1 at x = 1.
scene::Scene integrated_squares(bool with_blue) {
  const TemporaryFolder folder;
  write_text(folder / "scene.json",
             R"({"format": "pellucid-scene", "version": 1, "resolution": [32, 32],
                 "camera": {"type": "orthographic", "eye": [0, 0, 5], "height": 2.4},
                 "energy": {"q": 50, "r": 100, "lambda": 2}, "objects": [)" +
                 swept_square("1", R"("color": "#ff0000", "importance": 0.1)") +
                 (with_blue ? "," + swept_square("-1", R"("color": "#0000ff", "importance": "s")")
                            : std::string()) +
                 "]}");
  return scene::load_scene(folder / "scene.json");
}

// A strip lies in one column of pixels, over which the mesh's opacity changes linearly: what
// differs from the ray at the pixel's centre is a mean over places of some pixels' width, half of
// which is the change of an opacity from pixel to pixel.
TEST(AgreementOptimizedScene, LinesOfIntegratedSurfacesHaveTheOpacitiesOfTheirMesh) {
  const scene::Scene own = integrated_squares(true);
  const scene::Scene scene = optimized(own, "decoupled-lists:patches=50");
  const Image exact = draw("raytrace", scene).image;
  const Image tree = draw("tree", scene, {{"lines", "2000"}}).image;
  EXPECT_GT(largest_difference(exact, draw("raytrace", own).image), 0.5);
  for (int y = 4; y < 28; ++y)
    for (int x = 4; x < 28; ++x) {
      float change = 0;
      for (int side : {-1, 1})
        change = std::max({change, glm::length(exact.at(x + side, y) - exact.at(x, y)),
                           glm::length(exact.at(x, y + side) - exact.at(x, y))});
      EXPECT_LE(glm::length(exact.at(x, y) - tree.at(x, y)), change + float_composite)
          << x << ' ' << y;
    }
}

/// Opaque points of radius 0.03 in front of an important blue sheet, in a picture of 4 × 4 pixels
/// of 1/2: at the centre of the first pixel, at the first of the next one's four samples, and at
/// the second of another one's frames (1/4 and 2/3 of the pixel from its top left corner).
scene::Scene points_between_samples() {
  scene::Scene scene = orthographic_scene(4, 4);
  scene::PointObject points;
  points.radius = 0.03;
  points.set.positions = {{-0.75, 0.75, 1}, {-0.375, 0.875, 1}, {0.125, 1 - 1.0 / 3, 1}};
  points.set.colors.assign(3, {1, 0, 0, 1});
  geometry::TriangleMesh sheet = full_layer(-1, Rgba(0, 0, 1, 1));
  sheet.importance.assign(4, 1);
  scene.objects = {{"points", points}, {"important", sheet}};
  return scene;
}

std::vector<float> opacities_of_points(const std::string& call, const scene::PixelSampling& own,
                                       const std::vector<scene::PixelSampling>& further) {
  scene::Scene scene = points_between_samples();
  scene.samples = own;
  optimize_opacities(*parse_opacities(call), {}, scene, further);
  EXPECT_EQ(scene.samples, own);
  std::vector<float> found;
  for (const Rgba& color : scene.objects[0].vertices().colors) found.push_back(color.a);
  return found;
}

// What is seen has by q = 3 a quarter of its opacity, by a series of the importance about as much;
// what is not has all of it.
TEST(UnitOptimizedScene, WhatAnyDrawnSampleSeesIsSeen) {
  for (const auto& [call, tolerance] :
       {std::pair("decoupled-lists:q=3,r=0", 0.0), std::pair("fourier-opacity:q=3,r=0", 0.25)}) {
    const auto expect = [&](const scene::PixelSampling& own,
                            const std::vector<scene::PixelSampling>& further,
                            const std::vector<bool>& seen) {
      const std::vector<float> found = opacities_of_points(call, own, further);
      for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(found[i], seen[i] ? 0.25 : 1, seen[i] ? tolerance : 0) << call << ' ' << i;
    };
    expect({}, {}, {true, false, false});
    expect({.per_axis = 2}, {}, {false, true, false});
    expect({.frames = 2}, {}, {false, false, true});
    expect({}, {{.per_axis = 2}}, {true, true, false});
    expect({.per_axis = 2}, {{.per_axis = 2}, {.frames = 2}}, {false, true, true});
  }
}

std::string refusal(const scene::Scene& scene, const std::string& call) {
  try {
    optimized(scene, call);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(UnitOptimizedScene, WhatHasNoOpacitiesOfVerticesIsRefused) {
  const scene::Scene scene = shapes_of_every_kind();
  EXPECT_THAT(refusal(scene, "raytrace"),
              HasSubstr("'raytrace' finds no opacities of vertices; accepted: "));
  EXPECT_THAT(refusal(scene, "fourier-opacity:per=fragment"), HasSubstr("accepted: per=element"));
  EXPECT_THAT(refusal(scene, "decoupled-lists:per=fragment"), HasSubstr("accepted: per=element"));
  scene::Scene dull = scene;
  dull.objects[1].vertices().importance.clear();
  EXPECT_THAT(refusal(dull, "decoupled-lists"), HasSubstr("nothing in the scene has importance"));
}

TEST(UnitOptimizedScene, IntegratorsThatMakeAnotherMeshAreRefused) {
  const scene::Scene own = integrated_squares(false);
  const scene::Scene scene = optimized(own, "decoupled-lists");
  for (const scene::MethodRow& row : surface_methods()) {
    const Parameters parameters(row.name, row.parameters, {});
    EXPECT_NO_THROW(row.make(own, parameters, {})) << row.name;
    try {
      row.make(scene, parameters, {});
      ADD_FAILURE() << row.name;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("opacities were optimized for the meshes"));
    }
  }
}

TEST(UnitOptimizedScene, AdaptiveCallsSampleBetweenPixelCentres) {
  std::vector<MethodCall> calls;
  for (const char* call :
       {"raytrace:adaptive=4", "raytrace", "fourier", "raytrace:adaptive=2", "raytrace:adaptive=4"})
    calls.push_back(parse_call(call, methods()));
  const std::vector<scene::PixelSampling> expected{{.per_axis = 2}, {.per_axis = 4}};
  EXPECT_EQ(further_samplings(calls), expected);
}

}  // namespace
}  // namespace pellucid::compare
