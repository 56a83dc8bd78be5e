// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <tbb/global_control.h>

#include <cmath>
#include <limits>
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

Metrics measured(const Image& a, const Image& b) { return metrics_of(PicturePair(a, b)); }

std::string error_of(const Image& a, const Image& b) {
  try {
    measured(a, b);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(UnitMetrics, ConstantsHaveClosedForms) {
  // Both means constant, no variance: SSIM = (2ab + C1) / (a² + b² + C1), exact in double but for
  // the rounding of the window's sum (1e-12).
  const double a = 0.25, b = 0.75, c1 = 1e-4;
  const Metrics m = measured(grey(20, 15, 0.25f), grey(20, 15, 0.75f));
  EXPECT_DOUBLE_EQ(*m.of("rmse"), 0.5);
  // The same, in decibels.
  EXPECT_NEAR(*m.of("psnr"), 20 * std::log10(2.0), 1e-12);
  EXPECT_NEAR(m.of("ssim").value(), (2 * a * b + c1) / (a * a + b * b + c1), 1e-12);
}

TEST(UnitMetrics, OneWrongValueIsFoundWhereItIs) {
  const Image reference = grey(31, 17, 0.5f);
  Image test = reference;
  test.at(7, 11).b = 0.125f;
  const Metrics m = measured(reference, test);
  EXPECT_DOUBLE_EQ(*m.of("rmse"), 0.375 / std::sqrt(3.0 * 31 * 17));
  EXPECT_EQ(m.of("max_error"), 0.375);
  EXPECT_EQ(m.max_error_x, 7);
  EXPECT_EQ(m.max_error_y, 11);
}

TEST(UnitMetrics, AlphaIsNotCompared) {
  Image test = grey(12, 12, 0.5f);
  for (Rgba& pixel : test.pixels) pixel.a = 0;
  EXPECT_EQ(rmse(grey(12, 12, 0.5f), test), 0);
}

TEST(UnitMetrics, BelowElevenPixelsThereIsNoSsim) {
  EXPECT_FALSE(ssim(grey(10, 40, 0.f), grey(10, 40, 1.f)).has_value());
  EXPECT_FALSE(ssim(grey(1, 1, 0.f), grey(1, 1, 0.f)).has_value());
  EXPECT_EQ(measured(grey(1, 1, 0.f), grey(1, 1, 0.5f)).of("rmse"), 0.5);
}

TEST(UnitMetrics, WrongPairsAreNamed) {
  EXPECT_THAT(error_of(grey(4, 3, 0), grey(3, 4, 0)), HasSubstr("3×4 pixels; accepted: 4×3"));
  EXPECT_THAT(error_of(Image(), Image()), HasSubstr("no pixels"));
  Image bad = grey(5, 5, 0);
  bad.at(2, 3).g = std::numeric_limits<float>::quiet_NaN();
  bad.at(4, 4).a = std::numeric_limits<float>::infinity();
  EXPECT_THAT(error_of(grey(5, 5, 0), bad), HasSubstr("test picture: 2 pixels are not finite"));
  EXPECT_THAT(error_of(bad, grey(5, 5, 0)), HasSubstr("the first at (2, 3)"));
  EXPECT_EQ(count_not_finite(bad), 2u);
}

TEST(UnitMetrics, DisplayedValuesHideWhatAScreenHides) {
  // 0.5 and 0.5005 are both shown as 128.
  const Comparison c = compare_images(grey(16, 16, 0.5f), grey(16, 16, 0.5005f));
  EXPECT_GT(*c.linear.of("rmse"), 4e-4);
  EXPECT_EQ(c.displayed.of("rmse"), 0);
  EXPECT_EQ(c.displayed.of("ssim"), 1);
}

TEST(PropertyMetrics, APictureEqualsItselfExactly) {
  for (const FormulaPair& pair : formula_pairs()) {
    const Image x = picture(40, 33, pair.y);
    const Metrics m = measured(x, x);
    EXPECT_EQ(m.of("rmse"), 0) << pair.name;
    EXPECT_EQ(m.of("psnr"), std::numeric_limits<double>::infinity()) << pair.name;
    EXPECT_EQ(m.of("ssim"), 1) << pair.name;
    EXPECT_EQ(m.of("max_error"), 0) << pair.name;
  }
}

TEST(PropertyMetrics, SameBitsForAnyNumberOfThreads) {
  const Image x = picture(300, 217, rings), y = picture(300, 217, grainy);
  const Metrics many = measured(x, y);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const Metrics single = measured(x, y);
  EXPECT_EQ(many.of("rmse"), single.of("rmse"));
  EXPECT_EQ(many.of("ssim"), single.of("ssim"));
}

// A row measures what the function of its name does.
TEST(PropertyMetrics, EveryRowMeasuresItsOwnNumber) {
  const Image x = picture(40, 33, rings), y = picture(40, 33, grainy);
  const std::map<std::string_view, std::optional<double>> functions = {
      {"rmse", rmse(x, y)},       {"psnr", psnr(x, y)},
      {"ssim", ssim(x, y)},       {"max_error", max_error(x, y).value},
      {"ms_ssim", ms_ssim(x, y)}, {"flip", flip(x, y)}};
  const Metrics m = measured(x, y);
  for (std::size_t row = 0; row < metrics().size(); ++row) {
    EXPECT_EQ(&m[row], &m.of(metrics()[row].name));
    if (const auto found = functions.find(metrics()[row].name); found != functions.end()) {
      EXPECT_EQ(m[row], found->second) << metrics()[row].name;
    }
  }
  EXPECT_THROW(m.of("rsme"), InputError);
}

/// `rounding` is the error of the values that went in. SSIM: bright pictures (1000²) lose
/// 1e-16 × 1e6 / 9e-4 = 1e-7 to cancellation in scikit-image; everything stays below the 1e-6
/// asked.
void expect_equal(const Metrics& got, const json& expected, double rounding,
                  const std::string& name) {
  const double error = expected["rmse"];
  EXPECT_NEAR(*got.of("rmse"), error, rounding) << name;
  EXPECT_NEAR(got.of("ssim").value(), expected["ssim"].get<double>(), 2e-7) << name;
  if (error > 0) {  // dPSNR = 20 / ln 10 dRMSE / RMSE
    EXPECT_NEAR(*got.of("psnr"), expected["psnr"].get<double>(), 9 * rounding / error + 1e-12)
        << name;
  }
  EXPECT_NEAR(*got.of("max_error"), expected["max_error"]["value"].get<double>(), rounding) << name;
}

TEST(UnitMetrics, BelowAWindowAtTheCoarsestScaleThereIsNoMsSsim) {
  EXPECT_FALSE(ms_ssim(grey(175, 400, 0.f), grey(175, 400, 1.f)).has_value());
  EXPECT_EQ(ms_ssim(grey(176, 176, 0.5f), grey(176, 176, 0.5f)), 1);
  EXPECT_EQ(ms_ssim(grey(176, 176, 2e38f), grey(176, 176, 2e38f)), 1);  // four are beyond a float
}

// Constants differ in luminance alone, which only the coarsest scale looks at: the power of its
// weight. 1e-12: the rounding of the windows' sums.
TEST(UnitMetrics, MsSsimOfConstantsHasAClosedForm) {
  const double a = 0.25, b = 0.75, c1 = 1e-4;
  EXPECT_NEAR(*ms_ssim(grey(180, 190, 0.25f), grey(180, 190, 0.75f)),
              std::pow((2 * a * b + c1) / (a * a + b * b + c1), 0.1333), 1e-12);
}

TEST(UnitMetrics, BiasHasASign) {
  Image test = grey(4, 2, 0.5f);
  test.at(1, 1).g = 0.25f;
  const Metrics m = measured(grey(4, 2, 0.5f), test);
  EXPECT_EQ(m.of("bias_g"), -0.25 / 8);
  EXPECT_EQ(m.of("bias_r"), 0);
}

TEST(UnitMetrics, OnlyThoseThatAreNamedAreMeasured) {
  const Image x = picture(30, 20, rings), y = picture(30, 20, grainy);
  const std::vector<std::string> names = {"p99", "ssim_luma8"};
  const Comparison c = compare_pair(PicturePair(x, y), names);
  for (const MetricRow& row : metrics())
    EXPECT_EQ(c.linear.of(row.name).has_value(), row.name == "p99" || row.name == "ssim_luma8")
        << row.name;
  const std::vector<std::string> unknown = {"msssim"};
  EXPECT_THROW(compare_pair(PicturePair(x, y), unknown), InputError);
  EXPECT_FALSE(measured(x, y).of("ssim_skimage").has_value());
}

// To 1e-7: the coarser pictures are float, and the weights' powers no larger than 1.
TEST(AgreementMetrics, MsSsimEqualsThePaperInDouble) {
  const json expected = json::parse(read_text(PELLUCID_TEST_DATA "/metrics.json"))["scaled"];
  const auto pairs = scaled_pairs();
  ASSERT_EQ(expected.size(), pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    ASSERT_EQ(expected[i]["name"], pairs[i].name);
    const int width = expected[i]["width"], height = expected[i]["height"];
    const auto found =
        ms_ssim(picture(width, height, pairs[i].x), picture(width, height, pairs[i].y));
    EXPECT_NEAR(found.value(), expected[i]["ms_ssim"].get<double>(), 1e-7) << pairs[i].name;
  }
}

// Others' numbers, with their conventions. Bright pictures lose 1e-7 to cancellation there.
TEST(AgreementMetrics, OthersNumbersAreReproduced) {
  const json expected = json::parse(read_text(PELLUCID_TEST_DATA "/metrics.json"))["pairs"];
  const std::vector<std::string> names = {"ssim_skimage", "ssim_luma8"};
  const auto pairs = formula_pairs();
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const int width = expected[i]["width"], height = expected[i]["height"];
    const Image x = picture(width, height, pairs[i].x), y = picture(width, height, pairs[i].y);
    const Metrics m = metrics_of(PicturePair(x, y), names);
    for (const std::string& name : names)
      EXPECT_NEAR(m.of(name).value(), expected[i]["others"][name].get<double>(), 1e-6)
          << pairs[i].name << ", " << name;
  }
}

TEST(AgreementMetrics, EqualScikitImage) {
  const json expected = json::parse(read_text(PELLUCID_TEST_DATA "/metrics.json"));
  const auto pairs = formula_pairs();
  ASSERT_EQ(expected["pairs"].size(), pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const json& e = expected["pairs"][i];
    ASSERT_EQ(e["name"], pairs[i].name);
    const int width = e["width"], height = e["height"];
    const Image x = picture(width, height, pairs[i].x), y = picture(width, height, pairs[i].y);
    const Comparison c = compare_images(x, y);
    expect_equal(c.linear, e["linear"], 1e-12, pairs[i].name);  // sums of doubles
    // n/255 in float errs by 3e-8 in either picture.
    expect_equal(c.displayed, e["displayed"], 6e-8, pairs[i].name + ", 8 bits");
    EXPECT_EQ(c.linear.max_error_x, e["linear"]["max_error"]["x"]) << pairs[i].name;
    EXPECT_EQ(c.linear.max_error_y, e["linear"]["max_error"]["y"]) << pairs[i].name;
  }
}

}  // namespace
}  // namespace pellucid::compare
