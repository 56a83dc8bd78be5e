// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/methods/surface_methods.h"

#include <gmock/gmock.h>

#include "compare/methods/distance_picture.h"
#include "core/error.h"
#include "core/files/output_file.h"
#include "integrators/surfaces/integrate_surface.h"
#include "scene/files/scene_file.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::compare {
namespace {

using ::testing::HasSubstr;

scene::Scene load(const std::string& objects) {
  const testing::TemporaryFolder folder;
  write_text(folder / "scene.json",
             R"({"format": "pellucid-scene", "version": 1, "resolution": [40, 30],
                 "lighting": "headlight", "objects": [)" +
                 objects + "]}");
  return scene::load_scene(folder / "scene.json");
}

/// Of radius 1.
constexpr const char* cylinder = R"({"surface": {"field": "formula:u=-y,v=x,w=0",
    "integrator": "hultquist:tolerance=1e-3", "seed": {"from": [1, 0, 0], "to": [1, 0, 1]},
    "duration": 3}, "color": {"by": "t", "map": "viridis"}, "opacity": 0.5})";

const scene::MethodRow& row_named(std::string_view name) {
  for (const scene::MethodRow& row : surface_methods())
    if (row.name == name) return row;
  throw std::runtime_error("no such row");
}

double value_of(const scene::Findings& findings, std::string_view name) {
  for (const scene::Measure& measure : findings.measures)
    if (measure.name == name) return measure.value;
  throw std::runtime_error("no such measure");
}

TEST(PropertySurfaceMethods, EveryIntegratorIsOne) {
  ASSERT_EQ(surface_methods().size(), integrators::integrators().size());
  for (std::size_t i = 0; i < integrators::integrators().size(); ++i) {
    EXPECT_EQ(surface_methods()[i].name, integrators::integrators()[i].name);
    EXPECT_EQ(surface_methods()[i].parameters.size(),
              integrators::integrators()[i].parameters.size());
  }
}

TEST(UnitSurfaceMethods, TheSurfaceIsThatOfTheCellsIntegrator) {
  const scene::Scene scene = load(cylinder);
  const scene::MethodRow& row = row_named("fixed-front");
  const Parameters parameters(row.name, row.parameters, {{"particles", "3"}, {"rows", "10"}});
  const auto renderer = row.make(scene, parameters, {});
  scene::RenderRequest counting;
  counting.layers = true;
  const scene::Rendering rendering = renderer->render(counting);
  EXPECT_GT(rendering.stats.fragments, 0u);
  EXPECT_EQ(rendering.stats.steps.front().name, "integrate");
  const scene::Findings findings = renderer->findings();
  EXPECT_EQ(value_of(findings, "triangles"), 2 * 2 * 10);
  EXPECT_EQ(value_of(findings, "particles"), 3);
  EXPECT_EQ(value_of(findings, "ended_duration"), 3);
  EXPECT_EQ(value_of(findings, "sheets"), 1);
  // The chord over 0.3 radians leaves the unit circle by its sagitta.
  EXPECT_NEAR(value_of(findings, "distance_max"), 1 - std::cos(0.15), 1e-9);
  EXPECT_LT(value_of(findings, "distance_mean"), value_of(findings, "distance_rms"));
  ASSERT_EQ(findings.pictures.size(), 1u);
  EXPECT_EQ(findings.pictures[0].image.width, 40);
}

TEST(UnitSurfaceMethods, ScenesWithoutOneIntegratedSurfaceAreRefused) {
  const std::string two = std::string(cylinder) + "," + cylinder;
  const scene::Scene scene = load(two);
  const scene::MethodRow& row = row_named("hultquist");
  try {
    row.make(scene, Parameters(row.name, row.parameters, {}), {});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("2 of its objects are integrated surfaces"));
  }
}

/// A square that fills the view: distances on the scale's ends give the map's ends.
TEST(UnitDistancePicture, ColoursAreThoseOfTheScale) {
  scene::Scene view;
  view.width = view.height = 9;
  view.camera.projection = scene::Projection::orthographic;
  view.camera.height = 0.5;
  geometry::TriangleMesh square;
  square.positions = {{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0.5, 0.5, 0}, {-0.5, 0.5, 0}};
  square.triangles = {{0, 1, 2}, {0, 2, 3}};
  const auto center = [&](double distance) {
    return distance_picture(view, square, std::vector<double>(4, distance)).image.at(4, 4);
  };
  const scene::MeasurePicture picture = distance_picture(view, square, std::vector<double>(4, 1));
  EXPECT_DOUBLE_EQ(picture.min, 1e-6);  // the diagonal is √2
  EXPECT_DOUBLE_EQ(picture.max, 1e-2);
  EXPECT_LT(center(0).r + center(0).g + center(0).b, 0.05);
  EXPECT_GT(center(1).r, 0.9);
  EXPECT_LT(center(1e-4).r, center(1).r);
  EXPECT_GT(center(1e-4).r, center(1e-6).r);
}

}  // namespace
}  // namespace pellucid::compare
