// SPDX-License-Identifier: GPL-3.0-or-later
// The scenes of the study of extremes: ground truth is within half an ulp of a float of their exact
// picture.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/trigonometric.hpp>

#include "groundtruth/methods/raytrace.h"
#include "scene/datasets/dataset.h"
#include "scene/datasets/stack.h"
#include "tests/support/pictures.h"

namespace pellucid::groundtruth {
namespace {

struct StackCase {
  const char* options;
  int layers;
  double alpha;
  double scale = 1, shift = 0;
  scene::Projection projection = scene::Projection::orthographic;
};

void PrintTo(const StackCase& stack, std::ostream* out) { *out << stack.options; }

/// Lines and points cover what the camera sees.
scene::SceneObject object_of(const StackCase& stack) {
  const scene::Dataset data = scene::make_dataset(std::string("stack:") + stack.options);
  if (const auto* lines = std::get_if<geometry::LineSet>(&data))
    return {"stack", scene::LineObject{*lines, 2 * stack.scale}};
  if (const auto* points = std::get_if<geometry::PointSet>(&data))
    return {"stack", scene::PointObject{*points, 3 * stack.scale}};
  return {"stack", std::get<geometry::TriangleMesh>(data)};
}

/// The camera sees [-1, 1]² of a stack of scale 1 at its middle.
scene::Scene scene_of(const StackCase& stack) {
  scene::Scene scene;
  scene.width = scene.height = 17;  // the middle row and column run through the grid's edges
  const Vec3 center(stack.shift);
  scene.camera = {.projection = stack.projection,
                  .eye = center + Vec3(0, 0, 5 * stack.scale),
                  .target = center,
                  .fov = glm::degrees(2 * std::atan(1.0 / 5)),
                  .height = 2 * stack.scale};
  scene.objects.push_back(object_of(stack));
  return scene;
}

/// Eq. 12 of Baeza Rojo et al. 2019, in extended precision.
Rgba exact_pixel(const StackCase& stack, const Vec3& background) {
  long double transmittance = 1, color[3] = {0, 0, 0};
  for (int i = 0; i < stack.layers; ++i) {
    const Rgba sheet = scene::stack_color(i, stack.alpha);
    for (int c = 0; c < 3; ++c) color[c] += transmittance * sheet.a * sheet[c];
    transmittance *= 1 - static_cast<long double>(sheet.a);
  }
  for (int c = 0; c < 3; ++c) color[c] += transmittance * background[c];
  return {float(color[0]), float(color[1]), float(color[2]), float(1 - transmittance)};
}

class UnitExtremes : public ::testing::TestWithParam<StackCase> {};

TEST_P(UnitExtremes, GroundTruthIsTheClosedForm) {
  const scene::Scene scene = scene_of(GetParam());
  const scene::Rendering rendering = testing::render(raytrace_method(), scene, {}, true);
  const Rgba exact = exact_pixel(GetParam(), scene.background);
  // An ulp of a float just below 1: both sides were rounded once.
  for (const Rgba& pixel : rendering.image.pixels)
    for (int c = 0; c < 4; ++c) ASSERT_NEAR(pixel[c], exact[c], 6e-8);
  for (const std::uint32_t layers : rendering.layers.pixels)
    ASSERT_EQ(layers, std::uint32_t(GetParam().layers));
}

INSTANTIATE_TEST_SUITE_P(
    Stacks, UnitExtremes,
    ::testing::Values(
        StackCase{"layers=1,alpha=0.5", 1, 0.5}, StackCase{"layers=1000,alpha=0.005", 1000, 0.005},
        StackCase{"layers=10000,alpha=0.0005", 10000, 0.0005}, StackCase{"alpha=0", 8, 0},
        StackCase{"alpha=1e-8", 8, 1e-8}, StackCase{"alpha=0.9999", 8, 0.9999},
        StackCase{"alpha=0.9999999", 8, 0.9999999}, StackCase{"alpha=1", 8, 1},
        StackCase{"depths=equal,order=front", 8, 0.3}, StackCase{"depths=ulp,order=front", 8, 0.3},
        StackCase{"scale=1e10", 8, 0.3, 1e10}, StackCase{"scale=1e-10", 8, 0.3, 1e-10},
        StackCase{"shift=1e7", 8, 0.3, 1, 1e7}, StackCase{"sheet=grid", 8, 0.3},
        StackCase{"sheet=needles", 8, 0.3},
        StackCase{"sheet=line,layers=1000,alpha=0.005", 1000, 0.005},
        StackCase{"sheet=line,depths=equal,order=front", 8, 0.3},
        StackCase{"sheet=line,scale=1e10", 8, 0.3, 1e10},
        StackCase{"sheet=line,shift=1e7", 8, 0.3, 1, 1e7},
        StackCase{"sheet=point,layers=1000,alpha=0.005", 1000, 0.005},
        StackCase{"sheet=point,depths=equal,order=front", 8, 0.3},
        StackCase{"sheet=point,scale=1e10", 8, 0.3, 1e10},
        StackCase{"sheet=point,shift=1e7", 8, 0.3, 1, 1e7},
        StackCase{"layers=8", 8, 0.3, 1, 0, scene::Projection::perspective},
        StackCase{"sheet=line", 8, 0.3, 1, 0, scene::Projection::perspective},
        StackCase{"sheet=point", 8, 0.3, 1, 0, scene::Projection::perspective}));

}  // namespace
}  // namespace pellucid::groundtruth
