// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/measures/layers/layer_pictures.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace pellucid::compare {
namespace {

CountImage counts(std::vector<std::uint32_t> numbers) {
  CountImage image(int(numbers.size()), 1);
  image.pixels = std::move(numbers);
  return image;
}

/// So many pixels have so many layers more than the reference.
double pixels_at(const RowCurve& histogram, double by) {
  const auto found = std::ranges::find(histogram.x, by);
  return histogram.y.at(std::size_t(found - histogram.x.begin()));
}

// An 8-bit step is 1/255.
TEST(UnitLayerPictures, FewLayersAreToldApart) {
  CellMeasurement measured;
  measured.layers = counts({0, 1, 2, 3, 4, 8, 16, 32});
  add_layer_picture(measured);
  const Image& picture = measured.further.at(0);
  EXPECT_EQ(picture.pixels[0], Rgba(1));
  for (std::size_t i = 0; i < picture.pixels.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_GT(glm::length(picture.pixels[i] - picture.pixels[j]), 0.1f) << i << ' ' << j;
}

TEST(UnitLayerPictures, DifferencesAreCountedWithTheirSign) {
  CellMeasurement measured;
  measured.layers = counts({0, 3, 1, 2, 0, 90});
  add_layer_difference(counts({0, 1, 3, 2, 2, 0}), measured);
  const RowCurve& histogram = measured.row.curves.at(0);
  EXPECT_EQ(pixels_at(histogram, 0), 1);  // the first pixel, which is empty, does not count
  EXPECT_EQ(pixels_at(histogram, 2), 1);
  EXPECT_EQ(pixels_at(histogram, -2), 2);
  EXPECT_EQ(pixels_at(histogram, 16), 1);
  const Image& picture = measured.further.at(0);
  EXPECT_EQ(picture.pixels[0], Rgba(1));
  EXPECT_EQ(picture.pixels[3], Rgba(1));
  EXPECT_EQ(picture.pixels[1], picture.pixels[2]);
  EXPECT_NE(picture.pixels[1], picture.pixels[5]);
}

}  // namespace
}  // namespace pellucid::compare
