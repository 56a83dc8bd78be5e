// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/measures/study_measures.h"

#include <gmock/gmock.h>

#include "compare/cells/cell.h"
#include "compare/study/study.h"
#include "core/error.h"
#include "tests/compare/fake_methods.h"
#include "tests/compare/measures/measured.h"
#include "tests/compare/study_folder.h"
#include "tests/support/scenes.h"

namespace pellucid::compare {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using namespace pellucid::compare::testing;

// The nearer layer lies at d = 0 on the left half and at d = 1/2 on the right one.
TEST(UnitDepthError, IsTheMeanErrorOfThePixelsAtADepth) {
  scene::Scene scene = orthographic_scene(4, 2);
  scene.objects.push_back({"left", rectangle(-3, 0, -2, 2, 1, Rgba(1, 0, 0, 0.5))});
  scene.objects.push_back({"right", rectangle(0, 3, -2, 2, 0, Rgba(1, 0, 0, 0.5))});
  scene.objects.push_back({"behind", full_layer(-1, Rgba(1, 0, 0, 0.5))});
  const Image reference(4, 2, Rgba(0.5));
  CellMeasurement cell = picture_of(scene, Rgba(0.5));
  cell.image.at(0, 0) = Rgba(0.9f, 0.5f, 0.6f, 0.5f);
  depth_error_measure().measure(seen(scene, reference), cell);
  const RowCurve& curve = cell.row.curves.at(0);
  ASSERT_EQ(curve.x.size(), 2u);
  EXPECT_NEAR(curve.x[0], 0, 1.0 / 220);
  EXPECT_NEAR(curve.x[1], 0.5, 1.0 / 220);
  // A difference of floats below 1, 6e-8, over four pixels.
  EXPECT_NEAR(curve.y[0], 0.4 / 4, 6e-8);
  EXPECT_EQ(curve.y[1], 0);
}

// Important on the left half, context on the right one, nothing at the bottom.
TEST(UnitImportanceError, IsApartOfImportantPixelsAndOfContext) {
  scene::Scene scene = orthographic_scene(4, 2);
  scene.objects.push_back({"left", rectangle(-3, 0, 0, 2, 1, Rgba(1, 0, 0, 0.5))});
  scene.objects.push_back({"right", rectangle(0, 3, 0, 2, 0, Rgba(1, 0, 0, 0.5))});
  scene.objects[0].mesh().importance.assign(scene.objects[0].mesh().positions.size(), 0.75f);
  scene.objects[1].mesh().importance.assign(scene.objects[1].mesh().positions.size(), 0.25f);
  const Image reference(4, 2, Rgba(0.5));
  CellMeasurement cell = picture_of(scene, Rgba(0.5));
  cell.image.at(0, 0) = Rgba(0.5f, 0.75f, 0.5f, 1);
  cell.image.at(3, 0) = Rgba(1, 1, 1, 1);
  cell.image.at(0, 1) = Rgba(0);
  importance_error_measure().measure(seen(scene, reference), cell);
  ASSERT_EQ(cell.row.measures.size(), 2u);
  EXPECT_EQ(cell.row.measures[0].name, "rmse_important");
  EXPECT_DOUBLE_EQ(cell.row.measures[0].value, 0.25 / std::sqrt(6.0));
  EXPECT_EQ(cell.row.measures[1].name, "rmse_context");
  EXPECT_DOUBLE_EQ(cell.row.measures[1].value, 0.5 / std::sqrt(2.0));
}

TEST(UnitImportanceError, IsNotKnownWhereNothingIsImportant) {
  scene::Scene scene = orthographic_scene(4, 2);
  scene.objects.push_back({"layer", full_layer(0, Rgba(1, 0, 0, 0.5))});
  CellMeasurement cell = picture_of(scene, Rgba(0.5));
  importance_error_measure().measure(seen(scene, Image(4, 2, Rgba(0.25))), cell);
  EXPECT_TRUE(cell.row.measures.empty());
}

/// What rays tell, made up.
MeasuredScene told(const scene::Scene& scene, const Image& reference, const RayFacts& facts) {
  return {scene, reference, [&facts]() -> const RayFacts& { return facts; }};
}

double value_of(const CellMeasurement& cell, std::string_view name) {
  const auto found = std::ranges::find(cell.row.measures, name, &scene::Measure::name);
  return found == cell.row.measures.end() ? std::nan("") : found->value;
}

// Of ten bins: from the first pixel to the second the middle of a bin lies between, from the second
// to the third a boundary; the third and the fourth are more than half a bin apart.
TEST(UnitBinSteps, AreThoseOfTheSignedErrorOverThoseInTheMiddle) {
  const scene::Scene scene = orthographic_scene(5, 2);
  RayFacts facts;
  facts.shown_depth = Raster<double>(5, 2);
  const double depths[] = {0.03, 0.07, 0.11, 0.19, std::nan("")};
  const float errors[] = {0.5f, 0.25f, -0.25f, 0.75f, 0};
  const Image reference(5, 2, Rgba(0.25));
  CellMeasurement cell = picture_of(scene, Rgba(0.25));
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 5; ++x) {
      facts.shown_depth.at(x, y) = depths[x];
      cell.image.at(x, y).g += errors[x];
    }
  bin_steps_measure().measure(told(scene, reference, facts), cell);
  EXPECT_TRUE(cell.row.measures.empty());  // the method has no bins
  cell.row.parameter_values = {{"bins", "10"}};
  bin_steps_measure().measure(told(scene, reference, facts), cell);
  EXPECT_DOUBLE_EQ(value_of(cell, "boundary_step"), 0.5 / std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(value_of(cell, "boundary_step_ratio"), 2);
}

// The context is red before blue and green before blue; it shows by 0.25 and 0.75, once each as far
// from blue: by 0.5 over both. The first is very close.
TEST(UnitContextShare, IsHowMuchOfItsColourAPixelHas) {
  const scene::Scene scene = orthographic_scene(3, 1);
  RayFacts facts;
  facts.importance = Raster<double>(3, 1, 0);
  facts.context = Raster<ContextOfRay>(3, 1);
  facts.context.at(0, 0) = {1, Vec3(1, 0, 0), Vec3(0, 0, 1), 0.005};
  facts.context.at(1, 0) = {1, Vec3(0, 1, 0), Vec3(0, 0, 1), 0.5};
  CellMeasurement cell = picture_of(scene, Rgba(1));  // the last pixel has no context
  cell.image.at(0, 0) = Rgba(0.25f, 0, 0.75f, 1);
  cell.image.at(1, 0) = Rgba(0, 0.75f, 0.25f, 1);
  context_share_measure().measure(told(scene, {}, facts), cell);
  EXPECT_DOUBLE_EQ(value_of(cell, "context_share"), 0.5);
  EXPECT_DOUBLE_EQ(value_of(cell, "context_share_close"), 0.25);
  EXPECT_TRUE(std::isnan(value_of(cell, "context_share_beside")));
}

// Black context before white shows by 0.75 five columns from what is important, and hides all
// behind the sixth.
TEST(UnitContextShare, BesideWhatIsImportantEndsAfterFivePixels) {
  const scene::Scene scene = orthographic_scene(7, 1);
  RayFacts facts;
  facts.importance = Raster<double>(7, 1, 0);
  facts.context = Raster<ContextOfRay>(7, 1);
  facts.importance.at(0, 0) = 0.5;
  for (const int x : {5, 6}) facts.context.at(x, 0) = {2, Vec3(0), Vec3(1)};
  CellMeasurement cell = picture_of(scene, Rgba(0));
  cell.image.at(5, 0) = Rgba(0.25f, 0.25f, 0.25f, 1);
  context_share_measure().measure(told(scene, {}, facts), cell);
  EXPECT_DOUBLE_EQ(value_of(cell, "context_share_beside"), 0.75);
  EXPECT_TRUE(std::isnan(value_of(cell, "context_share")));
}

// Red and green context before an important blue layer, which shows most, at d of 0, 1/4, 1/2, 1.
TEST(UnitRayFacts, TellWhatShowsMostAndTheContextInFrontOfImportantLayers) {
  scene::Scene scene = orthographic_scene(3, 2);
  scene.background = {1, 0.5, 0.25};
  const std::pair<double, Rgba> layers[] = {{1, Rgba(1, 0, 0, 0.25)},
                                            {0.5, Rgba(0, 1, 0, 0.25)},
                                            {0, Rgba(0, 0, 1, 1)},
                                            {-1, Rgba(1, 1, 1, 1)}};
  for (const auto& [z, color] : layers) {
    scene.objects.push_back(sheet(z, color));
    scene.objects.back().mesh().importance.assign(4, color.b == 1 ? 0.5f : 0.25f);
  }
  const RayFacts facts = ray_facts(scene);
  // The range is wider than the layers by a margin of 1e-5 of it at most.
  EXPECT_NEAR(facts.nearest_depth.at(2, 1), 0, 2e-5);
  EXPECT_NEAR(facts.shown_depth.at(2, 1), 0.5, 2e-5);
  const ContextOfRay& context = facts.context.at(2, 1);
  EXPECT_EQ(context.layers, 2);
  EXPECT_EQ(context.color, Vec3(0.5, 0.5, 0));
  EXPECT_EQ(context.behind, Vec3(0, 0, 1));
  EXPECT_NEAR(context.gap, 0.25, 2e-5);
  std::swap(scene.objects[0].mesh().importance, scene.objects[2].mesh().importance);
  EXPECT_EQ(ray_facts(scene).context.at(2, 1).layers, 0);
  scene.objects.erase(scene.objects.begin());
  scene.objects.pop_back();  // green and blue are left, neither important
  const ContextOfRay alone = ray_facts(scene).context.at(2, 1);
  EXPECT_EQ(alone.layers, 2);
  EXPECT_EQ(alone.behind, scene.background);
  EXPECT_TRUE(std::isnan(alone.gap));
}

TEST(UnitLongestStep, IsCountedFromOne) {
  const scene::Scene scene = orthographic_scene(1, 1);
  CellMeasurement cell = picture_of(scene, Rgba(1));
  cell.row.steps = {{"all", {3, 3, 3}}};
  longest_step_measure().measure(told(scene, {}, {}), cell);
  EXPECT_TRUE(cell.row.measures.empty());
  cell.row.steps = {{"project", {1, 1, 9}}, {"weight", {4, 3, 5}}, {"composite", {2, 1, 8}}};
  longest_step_measure().measure(told(scene, {}, {}), cell);
  EXPECT_EQ(value_of(cell, "longest_step"), 2);
}

TEST(UnitStudyMeasures, AStudyNamesThem) {
  const testing::StudyFolder folder;
  const auto load = [&](const std::string& more) {
    return load_study(folder.study(R"(["shifted"])", more), testing::fake_methods());
  };
  const Study study = load(R"("measures": ["hull"], "probes": {"two": [[3, 4], [5, 6]]})");
  EXPECT_THAT(study.measures, ElementsAre("hull"));
  EXPECT_EQ(study.probes.at("two").at(1).y, 6);
  const std::vector<Cell> cells = expand_cells(study);
  EXPECT_TRUE(cells[1].probes.empty());
  EXPECT_EQ(cells[3].probes.size(), 2u);
  try {
    load(R"("measures": ["hul"])");
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("measures[0]: unknown measure 'hul'; known: hull"));
  }
}

}  // namespace
}  // namespace pellucid::compare
