// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/pictures/picture_pair.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "compare/pictures/metrics.h"
#include "core/error.h"
#include "core/files/output_file.h"
#include "tests/compare/pictures/metric_pairs.h"

namespace pellucid::compare {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using namespace pellucid::compare::testing;

Metrics measured(const Image& x, const Image& y, const PairRegions& regions) {
  return metrics_of(PicturePair(x, y, regions));
}

std::string error_of(const Image& a, const Image& b, const PairRegions& regions) {
  try {
    measured(a, b, regions);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

/// An error of 0.5 in the left half, of 0.125 in one pixel of the right one.
struct Halves {
  Image reference = grey(40, 30, 0.25f), test = reference;
  Mask left = Mask(40, 30), right = Mask(40, 30);
  CountImage layers = CountImage(40, 30), test_layers = CountImage(40, 30);

  Halves() {
    for (int y = 0; y < 30; ++y)
      for (int x = 0; x < 40; ++x) {
        if (x < 20) test.at(x, y) = Rgba(0.75f);
        (x < 20 ? left : right).at(x, y) = 1;
        layers.at(x, y) = x < 20 ? 2 : 0;
        test_layers.at(x, y) = x < 20 ? 1 : 0;
      }
    test.at(33, 7).g = 0.375f;
  }
};

TEST(UnitPicturePair, AMaskKeepsTheRestOut) {
  const Halves h;
  const Metrics left = measured(h.reference, h.test, {.mask = &h.left});
  EXPECT_DOUBLE_EQ(*left.of("rmse"), 0.5);
  EXPECT_EQ(left.of("max_error"), 0.5);
  EXPECT_EQ(left.of("bias_g"), 0.5);
  const Metrics right = measured(h.reference, h.test, {.mask = &h.right});
  EXPECT_DOUBLE_EQ(*right.of("rmse"), 0.125 / std::sqrt(3.0 * 600));
  EXPECT_EQ(right.of("max_error"), 0.125);
  EXPECT_EQ(right.max_error_x, 33);
  EXPECT_EQ(right.max_error_y, 7);
  EXPECT_DOUBLE_EQ(*right.of("bias_g"), 0.125 / 600);
  EXPECT_EQ(right.of("bias_r"), 0);
  EXPECT_EQ(right.of("ms_ssim"), std::nullopt);
}

// Layers make masks of their own: what a background hides is not in them.
TEST(UnitPicturePair, RegionsComeFromLayers) {
  const Halves h;
  const Metrics m =
      measured(h.reference, h.test, {.reference_layers = &h.layers, .test_layers = &h.test_layers});
  EXPECT_EQ(m.covered, 0.5);
  EXPECT_DOUBLE_EQ(*m.of("rmse_covered"), 0.5);
  EXPECT_EQ(m.of("max_error_equal"), 0.125);
  EXPECT_DOUBLE_EQ(*m.of("rmse_equal"), 0.125 / std::sqrt(3.0 * 600));
  EXPECT_GT(*m.of("flip_covered"), *m.of("flip"));
}

// The example of docs/evaluation.md: a textured disc that is drawn all black, on white. The numbers
// are scikit-image's, to the digits of the page.
TEST(UnitPicturePair, ABackgroundHidesABlackBlob) {
  Image reference = grey(200, 200, 1.f), test = reference;
  CountImage layers(200, 200);
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 200; ++x) {
      if ((x - 100) * (x - 100) + (y - 100) * (y - 100) >= 22 * 22) continue;
      layers.at(x, y) = 1;
      for (int c = 0; c < 3; ++c) reference.at(x, y)[c] = float(rings(x, y, c));
      test.at(x, y) = Rgba(0, 0, 0, 1);
    }
  const Metrics m = measured(reference, test, {.reference_layers = &layers});
  EXPECT_NEAR(*m.covered, 0.038, 5e-4);
  EXPECT_NEAR(*m.of("ssim"), 0.957, 5e-4);
  EXPECT_NEAR(*m.of("ssim_covered"), 0.084, 5e-4);
}

// A mask and layers together count where both do.
TEST(UnitPicturePair, AMaskCutsRegionsToo) {
  const Halves h;
  Mask corner(40, 30);
  for (int x = 10; x < 40; ++x) corner.at(x, 3) = 1;
  const Metrics m = measured(h.reference, h.test, {.mask = &corner, .reference_layers = &h.layers});
  EXPECT_DOUBLE_EQ(*m.covered, 1.0 / 3);
  EXPECT_DOUBLE_EQ(*m.of("rmse_covered"), 0.5);
  EXPECT_EQ(m.of("rmse_equal"), std::nullopt);
}

TEST(UnitPicturePair, WhatIsNotKnownIsNotZero) {
  const Image x = grey(20, 20, 0.5f);
  const CountImage none(20, 20);
  const Metrics unknown = measured(x, x, {}), empty = measured(x, x, {.reference_layers = &none});
  for (std::size_t i = 0; i < metrics().size(); ++i)
    if (metrics()[i].region != Region::all) {
      EXPECT_EQ(unknown[i], std::nullopt) << metrics()[i].name;
      EXPECT_EQ(empty[i], std::nullopt) << metrics()[i].name;
    }
  EXPECT_EQ(unknown.covered, std::nullopt);
  EXPECT_EQ(empty.covered, 0);
}

// The least error that a share of 100 pixels does not exceed: the 95th and the 99th of the sorted.
TEST(UnitPicturePair, PercentilesAreRanks) {
  const Image x = grey(10, 10, 0.f);
  Image y = x;
  for (int i = 0; i < 100; ++i) y.pixels[std::size_t((i * 37) % 100)].b = float(i + 1) / 128;
  const Metrics m = measured(x, y, {});
  EXPECT_EQ(m.of("p95"), 95.0 / 128);
  EXPECT_EQ(m.of("p99"), 99.0 / 128);
  EXPECT_EQ(measured(grey(1, 1, 0.f), grey(1, 1, 0.25f), {}).of("p95"), 0.25);
}

TEST(UnitPicturePair, WrongMasksAndLayersAreNamed) {
  const Image x = grey(4, 3, 0.f);
  const Mask large(5, 3, 1), empty(4, 3);
  const CountImage tall(4, 4);
  EXPECT_THAT(error_of(x, x, {.mask = &large}), HasSubstr("mask: 5×3 pixels; accepted: 4×3"));
  EXPECT_THAT(error_of(x, x, {.mask = &empty}), HasSubstr("no pixel of it counts"));
  EXPECT_THAT(error_of(x, x, {.reference_layers = &tall}), HasSubstr("reference's layers: 4×4"));
}

// A mask of all pixels is no mask, but for what has no map.
TEST(PropertyPicturePair, AllPixelsAreTheWholePicture) {
  for (const FormulaPair& pair : formula_pairs()) {
    const Image x = picture(40, 33, pair.x), y = picture(40, 33, pair.y);
    const Mask all(40, 33, 1);
    const CountImage ones(40, 33, 1);
    const Metrics m =
        measured(x, y, {.mask = &all, .reference_layers = &ones, .test_layers = &ones});
    const Metrics whole = measured(x, y, {});
    for (const MetricRow& row : metrics()) {
      const bool part = row.region != Region::all;
      const std::string_view base = part ? row.name.substr(0, row.name.rfind('_')) : row.name;
      EXPECT_EQ(m.of(row.name), row.on_request ? std::nullopt : whole.of(base)) << row.name;
    }
    EXPECT_EQ(m.covered, 1);
  }
}

// scikit-image's map of SSIM averaged over the mask, to 1e-6, the rest to the rounding of sums;
// bright pictures lose 1e-16 × 1e6 / 9e-4 of SSIM to cancellation there.
void expect_equal(const Metrics& got, const std::string& suffix, const json& expected,
                  const std::string& pair) {
  for (const auto& [name, value] : expected.items()) {
    if (name == "pixels") continue;
    const double bound = name == "ssim" ? 1e-6 : 1e-12;
    EXPECT_NEAR(got.of(name + suffix).value(), value.get<double>(), bound) << pair << ", " << name;
  }
}

TEST(AgreementPicturePair, MaskedNumbersEqualScikitImagesMap) {
  const json expected = json::parse(read_text(PELLUCID_TEST_DATA "/metrics.json"))["pairs"];
  const auto pairs = formula_pairs();
  int held = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const json& e = expected[i];
    if (!e.contains("masked")) continue;
    const int width = e["width"], height = e["height"];
    const Image x = picture(width, height, pairs[i].x), y = picture(width, height, pairs[i].y);
    const Mask mask = mask_by_hash(width, height);
    const CountImage here = layers_by_hash(width, height, 4),
                     there = layers_by_hash(width, height, 3);
    ASSERT_EQ(count(mask), e["masked"]["pixels"]);
    expect_equal(measured(x, y, {.mask = &mask}), "", e["masked"], pairs[i].name);
    const Metrics m = measured(x, y, {.reference_layers = &there, .test_layers = &here});
    expect_equal(m, "_covered", e["covered"], pairs[i].name);
    expect_equal(m, "_equal", e["equal"], pairs[i].name);
    ++held;
  }
  EXPECT_EQ(held, 9);
}

}  // namespace
}  // namespace pellucid::compare
