// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/measures/layers/layer_error.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pellucid::compare {
namespace {

/// A method whose error is `of(n)` in every channel of a pixel of n layers; the reference is black.
RowCurve curve_of(std::vector<std::uint32_t> layers, double (*of)(double)) {
  const int width = int(layers.size());
  CountImage counts(width, 1);
  counts.pixels = layers;
  CellMeasurement measured;
  measured.image = Image(width, 1);
  for (int x = 0; x < width; ++x) measured.image.at(x, 0) = Rgba(float(of(layers[std::size_t(x)])));
  add_layer_error(Image(width, 1), counts, measured);
  return measured.row.curves.empty() ? RowCurve{} : measured.row.curves[0];
}

TEST(UnitLayerError, FewLayersStandAlone) {
  const RowCurve curve = curve_of({0, 1, 2, 16, 2, 1, 0, 3}, [](double n) { return n / 64; });
  EXPECT_EQ(curve.x, (std::vector<double>{1, 2, 3, 16}));
  EXPECT_EQ(curve.y, (std::vector<double>{1 / 64.0, 2 / 64.0, 3 / 64.0, 16 / 64.0}));
}

// RMSE of a class is of all its pixels: 0 and 1 in each channel give √½.
TEST(UnitLayerError, AClassIsItsPixelsRootMeanSquare) {
  CellMeasurement measured;
  measured.image = Image(2, 1);
  measured.image.at(1, 0) = Rgba(1);
  add_layer_error(Image(2, 1), CountImage(2, 1, 5), measured);
  EXPECT_DOUBLE_EQ(measured.row.curves.at(0).y.at(0), std::sqrt(0.5));
}

// Many layers share classes, in order, each within its own: no wider than a fourth root of two.
TEST(PropertyLayerError, ManyLayersShareClassesInOrder) {
  std::vector<std::uint32_t> layers;
  for (std::uint32_t n = 1; n <= 100000; n += 1 + n / 50) layers.push_back(n);
  const RowCurve curve = curve_of(layers, [](double n) { return std::log2(n) / 32; });
  EXPECT_LT(curve.x.size(), 16u + 4 * 13 + 1);
  EXPECT_GT(curve.x.size(), 60u);
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    EXPECT_GT(curve.x[i], i > 0 ? curve.x[i - 1] : 0);
    EXPECT_NEAR(curve.y[i], std::log2(curve.x[i]) / 32, 0.25 / 32) << curve.x[i];
  }
}

TEST(UnitLayerError, NothingCoveredIsNoCurve) {
  EXPECT_TRUE(curve_of({0, 0}, [](double) { return 1.0; }).x.empty());
}

}  // namespace
}  // namespace pellucid::compare
