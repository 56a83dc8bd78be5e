// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/pictures/flip.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>

#include "compare/pictures/flip_color.h"
#include "compare/pictures/metrics.h"
#include "core/files/output_file.h"
#include "tests/compare/pictures/metric_pairs.h"

namespace pellucid::compare {
namespace {

using nlohmann::json;
using namespace pellucid::compare::testing;

double mean(const Raster<float>& map) {
  return std::accumulate(map.pixels.begin(), map.pixels.end(), 0.0) / double(map.pixels.size());
}

Image of_color(float r, float g, float b) { return Image(8, 8, Rgba(r, g, b, 1)); }

// Roots are within the rounding of float (6e-8) and of the few operations of the last step.
TEST(UnitFlip, RootsArePowers) {
  for (double t = 1e-4; t < 1.2; t *= 1.003) {
    EXPECT_NEAR(root<3>(float(t)) / std::cbrt(double(float(t))), 1, 4e-7) << t;
    EXPECT_NEAR(root<5>(float(t)) / std::pow(double(float(t)), 0.2), 1, 4e-7) << t;
  }
}

TEST(UnitFlip, SrgbIsItsStandard) {
  for (int n = 0; n <= 1000; ++n) {
    const double v = n / 1000.0;
    const double linear = v > 0.04045 ? std::pow((v + 0.055) / 1.055, 2.4) : v / 12.92;
    EXPECT_NEAR(linear_of_srgb(float(v)), linear, 5e-7) << v;
  }
}

// The largest difference that there is has error 1 by definition; nothing exceeds it.
TEST(UnitFlip, GreenAndBlueAreFarthestApart) {
  const Image green = of_color(0, 1, 0), blue = of_color(0, 0, 1);
  EXPECT_NEAR(flip(green, blue), 1, 1e-6);
  for (const Image& a : {of_color(1, 0, 0), of_color(1, 1, 1), of_color(0, 0, 0), green})
    for (const Image& b : {of_color(1, 0, 1), of_color(1, 1, 0), of_color(0, 1, 1), blue})
      EXPECT_LE(flip(a, b), 1 + 1e-6);
}

// Two greys have no features and no chroma: HyAB is the difference of L*, so that the whole has a
// closed form. 5e-5: of the largest distance, 308, which two digits of a table give to 0.01.
TEST(UnitFlip, GreyConstantsHaveAClosedForm) {
  const auto lightness = [](double v) {
    return 116 * std::cbrt(std::pow((v + 0.055) / 1.055, 2.4)) - 16;
  };
  // The adjusted L*a*b* of green and blue from colour tables of L*a*b* under D65: (87.73, -86.18,
  // 83.18) and (32.30, 79.19, -107.86), to two digits.
  const double da = 0.8773 * -86.18 - 0.3230 * 79.19, db = 0.8773 * 83.18 - 0.3230 * -107.86;
  const double largest = std::pow(87.73 - 32.30 + std::hypot(da, db), 0.7);
  for (const auto& [a, b] : {std::pair(0.4, 0.5), std::pair(0.7526, 0.9075)}) {
    const double expected = 0.95 / (0.4 * largest) * std::pow(lightness(b) - lightness(a), 0.7);
    EXPECT_NEAR(flip(grey(30, 20, float(a)), grey(30, 20, float(b))), expected, 5e-5);
  }
}

// The example of docs/evaluation.md.
TEST(UnitFlip, SmallErrorsWeighMuch) {
  EXPECT_NEAR(flip(grey(12, 12, 0.5f), grey(12, 12, 0.501f)), 0.011, 5e-4);
}

TEST(UnitFlip, WhatADisplayClampsIsNotSeen) {
  EXPECT_EQ(flip(grey(12, 12, 1.f), grey(12, 12, 7.f)), 0);
  EXPECT_EQ(flip(grey(12, 12, 0.f), grey(12, 12, -1.f)), 0);
}

TEST(PropertyFlip, IsSymmetricAndZeroForEqualPictures) {
  for (const FormulaPair& pair : flip_pairs()) {
    const Image x = picture(40, 33, pair.x), y = picture(40, 33, pair.y);
    EXPECT_EQ(flip_map(x, y).pixels, flip_map(y, x).pixels) << pair.name;
    EXPECT_EQ(mean(flip_map(y, y)), 0) << pair.name;
  }
}

// Mirroring the pictures mirrors the map: no filter is off by a pixel. Sums run the other way.
TEST(PropertyFlip, FollowsMirrors) {
  const auto mirrored = [](const Formula& formula) -> Formula {
    return [formula](auto x, auto y, auto c) { return formula(69 - x, 109 - y, c); };
  };
  const Raster<float> map = flip_map(picture(70, 110, rings), picture(70, 110, grainy));
  const Raster<float> other =
      flip_map(picture(70, 110, mirrored(rings)), picture(70, 110, mirrored(grainy)));
  for (int y = 0; y < 110; ++y)
    for (int x = 0; x < 70; ++x) EXPECT_NEAR(map.at(x, y), other.at(69 - x, 109 - y), 1e-4);
}

TEST(PropertyFlip, SameBitsForAnyNumberOfThreads) {
  const Image x = picture(150, 217, rings), y = picture(150, 217, grainy);
  const Raster<float> many = flip_map(x, y);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(flip_map(x, y).pixels, many.pixels);
}

TEST(UnitFlip, ItsPictureIsDarkWhereNothingIsSeen) {
  const Image shown = flip_picture(Raster<float>(3, 2, 0.f));
  EXPECT_LT(std::max({shown.at(0, 0).r, shown.at(0, 0).g, shown.at(0, 0).b}), 0.05);
  EXPECT_GT(flip_picture(Raster<float>(3, 2, 1.f)).at(2, 1).r, 0.9);
}

// Dense filters in double, from the paper: the mean within 1e-4 and the largest within 1e-3, which
// is what single precision and the exact inverse of a matrix that is printed to nine digits allow.
TEST(AgreementFlip, EqualsThePaperInDouble) {
  const json expected = json::parse(read_text(PELLUCID_TEST_DATA "/flip.json"))["pairs"];
  const auto pairs = flip_pairs();
  ASSERT_EQ(expected.size(), pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const json& e = expected[i];
    ASSERT_EQ(e["name"], pairs[i].name);
    const int width = e["width"], height = e["height"];
    const Raster<float> map =
        flip_map(picture(width, height, pairs[i].x), picture(width, height, pairs[i].y));
    EXPECT_NEAR(mean(map), e["mean"].get<double>(), 1e-4) << pairs[i].name;
    EXPECT_NEAR(*std::ranges::max_element(map.pixels), e["max"].get<double>(), 1e-3)
        << pairs[i].name;
    EXPECT_NEAR(map.pixels.back(), e["last pixel"].get<double>(), 1e-3) << pairs[i].name;
  }
}

}  // namespace
}  // namespace pellucid::compare
