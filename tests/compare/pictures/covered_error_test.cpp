// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/pictures/covered_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "compare/pictures/metrics.h"

namespace pellucid::compare {
namespace {

Image noise(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> value(0, 1);
  Image image(width, height);
  for (Rgba& pixel : image.pixels)
    pixel = Rgba(value(random), value(random), value(random), value(random));
  return image;
}

// One channel is off by 0.3 in each of the covered pixels, and by 0.9 elsewhere.
TEST(UnitCoveredError, IsThatOfTheCoveredPixelsAlone) {
  const Image reference(4, 3, Rgba(0.f));
  Image test(4, 3, Rgba(0.9f));
  CountImage layers(4, 3, 0);
  for (int x = 0; x < 4; ++x) {
    test.at(x, 1) = Rgba(0.3f, 0, 0, 1);
    layers.at(x, 1) = 2;
  }
  const CoveredError error = covered_error(reference, layers, test);
  EXPECT_NEAR(*error.rmse, double(0.3f) / std::sqrt(3.0), 1e-15);
  EXPECT_FALSE(error.ssim);  // no window lies inside
}

TEST(UnitCoveredError, WithoutACoveredPixelThereIsNone) {
  const Image image = noise(16, 16, 1);
  const CoveredError error = covered_error(image, CountImage(16, 16, 0), image);
  EXPECT_FALSE(error.rmse);
  EXPECT_FALSE(error.ssim);
}

// SSIM's own loop sums in another order: a few ulp of a mean of values below 1.
TEST(AgreementCoveredError, OfAPictureThatIsCoveredItIsThePicturesOwn) {
  const Image reference = noise(23, 17, 2), test = noise(23, 17, 3);
  const CoveredError error = covered_error(reference, CountImage(23, 17, 1), test);
  EXPECT_NEAR(*error.rmse, rmse(reference, test), 1e-14);
  EXPECT_NEAR(*error.ssim, *ssim(reference, test), 1e-12);
}

TEST(PropertyCoveredError, EqualPicturesArePerfect) {
  const Image image = noise(23, 17, 4);
  const CoveredError error = covered_error(image, CountImage(23, 17, 1), image);
  EXPECT_EQ(*error.rmse, 0);
  EXPECT_NEAR(*error.ssim, 1, 1e-15);
}

}  // namespace
}  // namespace pellucid::compare
