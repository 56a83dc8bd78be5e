// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/measures/study_measures.h"

#include <gmock/gmock.h>

#include "compare/cells/ray_curves.h"
#include "compare/methods/methods.h"
#include "core/error.h"
#include "core/options/names.h"
#include "groundtruth/sums/fourier_sum.h"
#include "groundtruth/sums/ray_sums.h"
#include "tests/compare/fake_methods.h"
#include "tests/compare/study_folder.h"
#include "tests/support/scenes.h"

namespace pellucid::compare {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using namespace pellucid::compare::testing;

/// A picture of one colour.
CellMeasurement picture_of(const scene::Scene& scene, const Rgba& color) {
  CellMeasurement cell;
  cell.image = Image(scene.width, scene.height, color);
  return cell;
}

/// Rays are asked whenever a measure wants them.
MeasuredScene seen(const scene::Scene& scene, const Image& reference) {
  static RayFacts facts;
  return {scene, reference, [&scene]() -> const RayFacts& { return facts = ray_facts(scene); }};
}

/// A red and a green layer over blue.
scene::Scene red_green_blue() {
  scene::Scene scene =
      stack(2, 4, 3, [](int i) { return i == 0 ? Rgba(1, 0, 0, 0.5) : Rgba(0, 1, 0, 0.5); });
  scene.background = {0, 0, 1};
  return scene;
}

TEST(UnitHullMeasure, CountsThePixelsThatLeaveTheHull) {
  const scene::Scene scene = red_green_blue();
  CellMeasurement cell = picture_of(scene, Rgba(0.2, 0.3, 0.5, 1));
  // Along the normal of the plane r + g + b = 1, on which the hull lies.
  cell.image.at(2, 1) = Rgba(0.2 + 0.1, 0.3 + 0.1, 0.5 + 0.1, 1);
  hull_measure().measure(seen(scene, {}), cell);
  EXPECT_EQ(cell.row.measures[0].value, 1);
  // Three channels of a picture in float, 3e-8 each, and the projection's 1e-7.
  EXPECT_NEAR(cell.row.measures[1].value, 0.1 * std::sqrt(3.0), 2e-7);
  ASSERT_EQ(cell.further.size(), 1u);
  EXPECT_NE(cell.further[0].at(2, 1), cell.further[0].at(0, 0));
}

// The exact composite of red, green and blue at (0.2, 0.3, 0.5), as far as 8 bits have it, lies off
// the hull's plane by up to √3 / 2 of their steps.
TEST(UnitHullMeasure, RoundingTo8BitsLeavesNoHull) {
  const scene::Scene scene = red_green_blue();
  CellMeasurement cell = picture_of(scene, Rgba(51 / 255.f, 77 / 255.f, 128 / 255.f, 1));
  cell.row.given = "picture";
  hull_measure().measure(seen(scene, {}), cell);
  EXPECT_EQ(cell.row.measures[0].value, 0);
  EXPECT_LT(cell.row.measures[1].value, 1e-6);
}

TEST(UnitHullMeasure, AFullChannelStandsForAllThatIsCutOff) {
  scene::Scene scene = stack(1, 4, 3, [](int) { return Rgba(3, 1, 1, 0.5); });
  scene.background = {0, 0, 0};
  // (1.5, 0.5, 0.5), shown as (1, 0.5, 0.5).
  CellMeasurement cell = picture_of(scene, Rgba(1, 128 / 255.f, 128 / 255.f, 1));
  hull_measure().measure(seen(scene, {}), cell);
  EXPECT_EQ(cell.row.measures[0].value, 12);  // of a picture in float it is off
  CellMeasurement given = picture_of(scene, Rgba(1, 128 / 255.f, 128 / 255.f, 1));
  given.row.given = "picture";
  hull_measure().measure(seen(scene, {}), given);
  EXPECT_EQ(given.row.measures[0].value, 0);
}

TEST(UnitHullMeasure, LeavesOutPixelsWhoseLayersDiffer) {
  const scene::Scene scene = red_green_blue();
  CellMeasurement cell = picture_of(scene, Rgba(2, 2, 2, 1));
  cell.layers = CountImage(4, 3, 2);
  cell.layers.at(0, 0) = 1;
  hull_measure().measure(seen(scene, {}), cell);
  EXPECT_EQ(cell.row.measures[0].value, 11);
}

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

Cell probing_cell(std::string_view method, const RawOptions& options, bool reference) {
  const scene::MethodRow& row = find_row("method", method, methods());
  return {"",        "scene", {&row, Parameters(row.name, row.parameters, options)},
          reference, {},      {{1, 1}}};
}

CellMeasurement probed(const Cell& cell, const scene::Scene& scene) {
  const auto renderer = cell.call.row->make(scene, cell.call.parameters, {});
  renderer->render({});
  CellMeasurement measured;
  add_ray_curves(cell, scene, *renderer, measured);
  return measured;
}

/// Five layers of an opacity of 1/2 at d = 0.1, 0.3, 0.5, 0.7, 0.9, between two that cannot be seen
/// at the ends of the depth range.
scene::Scene five_steps() {
  scene::Scene scene = orthographic_scene(3, 3);
  for (const double d : {0.0, 0.1, 0.3, 0.5, 0.7, 0.9, 1.0})
    scene.objects.push_back(
        {"layer", full_layer(1 - 2 * d, Rgba(1, 0, 0, d == 0 || d == 1 ? 0 : 0.5))});
  return scene;
}

double steps_up_to(double d) {
  double sum = 0;
  for (const double step : {0.1, 0.3, 0.5, 0.7, 0.9}) sum += step <= d ? std::log(2) : 0;
  return sum;
}

bool near_a_step(double d) { return std::abs(std::remainder(d - 0.1, 0.2)) < 1e-3; }

TEST(UnitRayCurves, TheReferenceHasTheSteps) {
  const RowCurve curve = probed(probing_cell("raytrace", {}, true), five_steps()).row.curves.at(0);
  for (std::size_t i = 0; i < curve.x.size(); ++i)
    if (!near_a_step(curve.x[i])) {
      // Sums of at most five logarithms in double, and a hundred times their roundings: 5 · 4.4e-16
      // and more.
      EXPECT_NEAR(curve.y[i], steps_up_to(curve.x[i]), 1e-14);
    }
}

// Against the series summed in double. In the shader's k-th wave the error of the first one, 5e-7,
// and of the depth, two ulp of 1 in a rasterizer's float or 2π · 1.2e-7 of the angle, count k
// times; in the evaluated wave, too, whose depth is rounded once. They meet coefficients of up to
// 2 · 5 ln 2, divided by 2πk, of a_k and of b_k: 5.1e-6 a band.
TEST(AgreementRayCurves, FourierHasTheSeriesOfItsBands) {
  const scene::Scene scene = five_steps();
  // The range of depths is wider than the layers' by a little: theirs are not quite 0.1, 0.3, …
  const groundtruth::RaySums ray = groundtruth::RayProbe(scene).at(1.5, 1.5);
  for (const int bands : {1, 5, 20}) {
    groundtruth::FourierSum exact(bands);
    for (const groundtruth::RayLayer& layer : ray.layers)
      exact.add(-std::log1p(-layer.opacity), layer.d);
    const auto cell =
        probed(probing_cell("fourier", {{"bands", std::to_string(bands)}}, false), scene);
    const RowCurve& curve = cell.row.curves.at(0);
    for (std::size_t i = 0; i < curve.x.size(); ++i)
      // Sums of floats up to 7, an ulp of 4.8e-7, and in each band two coefficients of waves whose
      // depths are floats: ten ulps each.
      EXPECT_NEAR(curve.y[i], exact.up_to(curve.x[i]), 5e-6 + 5.1e-6 * bands)
          << bands << ' ' << curve.x[i];
    // Two curves of terms, the line of 5 % and the mark of five bands.
    ASSERT_EQ(cell.row.curves.size(), 5u);
    EXPECT_EQ(cell.row.curves[1].x.size(), std::size_t(bands));
    EXPECT_EQ(cell.row.measures.size(), bands < 5 ? 0u : bands == 5 ? 1u : 2u);
  }
}

// Impulses at one depth d have a_k = a_0 cos(2πkd), b_k = a_0 sin(2πkd): of F(1) = a_0 / 2 the
// terms are 100 |cos| / (πk) and 100 |sin| / (πk) per cent.
TEST(UnitRayCurves, TermsArePartsOfTheWholeSum) {
  const scene::Scene scene = stack(1, 3, 3, [](int) { return Rgba(1, 1, 1, 0.5f); });
  const double d = groundtruth::RayProbe(scene).at(1.5, 1.5).layers.at(0).d;
  const auto cell = probed(probing_cell("fourier", {{"bands", "7"}}, false), scene);
  const auto percent = [](double wave, int k) { return 100 * std::abs(wave) / (M_PI * k); };
  for (int k = 1; k <= 7; ++k) {
    const double angle = 2 * M_PI * k * d;
    // Waves are off by 5e-7 k, of 100 / (πk) per cent.
    EXPECT_NEAR(cell.row.curves[1].y[std::size_t(k) - 1], percent(std::cos(angle), k), 1e-4);
    EXPECT_NEAR(cell.row.curves[2].y[std::size_t(k) - 1], percent(std::sin(angle), k), 1e-4);
  }
  const auto larger = [&](int k) {
    return std::max(percent(std::cos(2 * M_PI * k * d), k), percent(std::sin(2 * M_PI * k * d), k));
  };
  EXPECT_EQ(cell.row.measures.at(0).name, "optical_depth_term_5");
  EXPECT_NEAR(cell.row.measures.at(0).value, larger(5), 1e-4);
  EXPECT_EQ(cell.row.measures.at(1).name, "optical_depth_terms_beyond_5");
  EXPECT_NEAR(cell.row.measures.at(1).value, std::max(larger(6), larger(7)), 1e-4);
}

// G is the scene's: the row of a reference that optimizes opacities has its exact steps.
TEST(AgreementRayCurves, ImportanceHasItsStepsAndItsSeries) {
  scene::Scene scene = five_steps();
  for (std::size_t i = 0; i < 5; ++i)
    scene.objects[i].vertices().importance.assign(4, i % 2 ? 1.0f : 0.5f);
  const groundtruth::RaySums ray = groundtruth::RayProbe(scene).at(1.5, 1.5);
  const auto exact = probed(probing_cell("decoupled-lists", {}, true), scene).row;
  ASSERT_EQ(exact.curves.size(), 1u);
  EXPECT_EQ(exact.curves[0].y_title, "G(d)");
  groundtruth::FourierSum sums(4);
  for (const groundtruth::RayLayer& layer : ray.layers)
    sums.add(layer.importance * layer.importance, layer.d);
  for (const char* resolution : {"full", "half"}) {
    const RawOptions options = {{"bands", "4"}, {"importance-resolution", resolution}};
    const auto row = probed(probing_cell("fourier-opacity", options, false), scene).row;
    const auto series = std::ranges::find(row.curves, "G(d)", &RowCurve::y_title);
    ASSERT_NE(series, row.curves.end());
    for (std::size_t i = 0; i < series->x.size(); ++i) {
      EXPECT_NEAR(exact.curves[0].y[i], ray.importance_sum(series->x[i]), 1e-12);
      // As of the optical depth, of a sum below 3.
      EXPECT_NEAR(series->y[i], sums.up_to(series->x[i]), 2e-5) << series->x[i];
    }
  }
}

// A step in the middle of each of five bins: constant bins are exact behind it, linear ones in it.
TEST(UnitRayCurves, BinsAreReadAsTheirModeSays) {
  for (const char* mode : {"constant", "linear"}) {
    const RowCurve curve =
        probed(probing_cell("binning", {{"bins", "5"}, {"mode", mode}}, false), five_steps())
            .row.curves.at(0);
    for (std::size_t i = 0; i + 1 < curve.x.size(); ++i) {
      const double bin = std::floor(curve.x[i] * 5 + 1e-9);
      const double expected = std::string_view(mode) == "linear" ? curve.x[i] * 5 : bin + 1;
      // Five floats up to 3.5 are summed, and depths shifted by the margin of 1e-5 do not cross a
      // bin.
      EXPECT_NEAR(curve.y[i], expected * std::log(2), 1e-5) << mode << ' ' << curve.x[i];
    }
  }
}

TEST(UnitRayCurves, MethodsWithoutSuchAFunctionHaveNone) {
  EXPECT_TRUE(probed(probing_cell("linked-list", {}, false), five_steps()).row.curves.empty());
}

TEST(UnitRayCurves, APixelOutsideThePictureIsRefused) {
  Cell cell = probing_cell("raytrace", {}, true);
  cell.probes = {{3, 0}};
  EXPECT_THROW(probed(cell, five_steps()), InputError);
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
