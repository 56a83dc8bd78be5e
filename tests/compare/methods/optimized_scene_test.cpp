// SPDX-License-Identifier: GPL-3.0-or-later
// Opacity optimization as a stage of its own: what any method composites after it.

#include <gmock/gmock.h>

#include "compare/methods/optimize_opacities.h"
#include "core/error.h"
#include "tests/compare/methods/opacity_scenes.h"
#include "tests/compare/methods/promise_scenes.h"

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

}  // namespace
}  // namespace pellucid::compare
