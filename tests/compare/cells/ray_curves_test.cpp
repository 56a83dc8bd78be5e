// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cells/ray_curves.h"

#include <gmock/gmock.h>

#include <cmath>

#include "compare/methods/methods.h"
#include "core/error.h"
#include "core/options/names.h"
#include "groundtruth/sums/fourier_sum.h"
#include "groundtruth/sums/ray_sums.h"
#include "tests/support/scenes.h"

namespace pellucid::compare {
namespace {

using namespace pellucid::testing;

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

// Of a sum of nothing no term is a part, and 0 would be the best of all.
TEST(UnitRayCurves, AnEmptyRayHasNoTerms) {
  scene::Scene scene = orthographic_scene(3, 3);
  scene.objects.push_back({"aside", rectangle(0.5, 0.9, 0.5, 0.9, 0, Rgba(1, 0, 0, 0.5))});
  const auto cell = probed(probing_cell("fourier", {{"bands", "7"}}, false), scene);
  EXPECT_TRUE(cell.row.measures.empty());
  EXPECT_EQ(cell.row.curves.size(), 1u);  // the sum itself, which is 0
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

}  // namespace
}  // namespace pellucid::compare
