// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/figure/figure_content.h"

#include <gmock/gmock.h>

#include "core/error.h"
#include "tests/compare/figure/figure_runs.h"

namespace pellucid::compare {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using testing::FigureRun;
using ::testing::HasSubstr;

std::string text_of(const std::vector<TextRun>& runs) {
  std::string text;
  for (const TextRun& run : runs)
    text += (run.is_raised ? "^" : "") + run.text + (run.is_bold ? "*" : "");
  return text;
}

std::vector<std::string> texts_of(const std::vector<std::vector<TextRun>>& lists) {
  std::vector<std::string> texts;
  for (const std::vector<TextRun>& runs : lists) texts.push_back(text_of(runs));
  return texts;
}

std::string refusal(FigureRun& run, const FigureRequest& request) {
  try {
    read_figure(run.run(), request);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

FigureRequest of_methods(const std::vector<std::string>& methods) {
  FigureRequest request;
  request.methods = methods;
  return request;
}

TEST(UnitFigureRows, ACommaAfterAParameterGoesOn) {
  EXPECT_THAT(methods_of_text("a,b:x=1,y=2,c"), ElementsAre("a", "b:x=1,y=2", "c"));
  EXPECT_THAT(methods_of_text("b:f=max(x,y)"), ElementsAre("b:f=max(x,y)"));
}

TEST(UnitFigureRows, AMethodsNameStandsForAllItsCalls) {
  FigureRun run;
  for (ResultRow& row : run.run().rows)
    if (row.method != "truth") row.parameters = row.method == "near" ? "n=1,m=2" : "n=3";
  for (ResultRow& row : run.run().rows)
    if (row.method != "truth") row.method = "series";
  const auto rows = find_figure_rows(run.run(), of_methods({"series,truth", "series:n=1,m=2"}));
  ASSERT_EQ(rows.size(), 2u);
  ASSERT_EQ(rows[1].rows.size(), 4u);
  EXPECT_EQ(rows[1].rows[1].call(), "series:n=3");
  EXPECT_EQ(rows[1].rows[2].call(), "truth");
  EXPECT_EQ(rows[1].rows[3].call(), "series:n=1,m=2");
  EXPECT_EQ(rows[1].rows[3].scene, "b");
}

TEST(UnitFigureRows, ASceneMayHaveACommaInItsName) {
  FigureRun run;
  for (ResultRow& row : run.run().rows)
    if (row.scene == "b") row.scene = "a,b";
  FigureRequest request;
  request.scenes = {"a,b", "a"};
  const auto rows = find_figure_rows(run.run(), request);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].scene, "a,b");
  EXPECT_EQ(rows[1].scene, "a");
  for (ResultRow& row : run.run().rows)
    if (row.scene == "a,b") row.scene = "b";
  request.scenes = {"a,b"};
  EXPECT_EQ(find_figure_rows(run.run(), request).size(), 2u);
}

/// It is the change of an error, which the reference does not have.
TEST(UnitFigureNumbers, TheReferenceDoesNotFlicker) {
  FigureRun run;
  for (ResultRow& row : run.run().rows)
    row.measures = {{"flicker", "Flicker", "", row.reference ? 0 : 0.125, Better::lower}};
  FigureRequest request;
  request.numbers = {"flicker"};
  const std::vector<FigureNumbers> numbers = read_figure(run.run(), request).strips[0].numbers;
  EXPECT_THAT(texts_of(numbers[0].errors), ElementsAre("reference"));
  EXPECT_TRUE(numbers[0].costs.empty());
  EXPECT_THAT(texts_of(numbers[1].errors), ElementsAre("Flicker 0.125*"));
}

TEST(UnitFigureNumbers, TheBestIsBoldAndTheReferenceHasCostsAlone) {
  FigureRun run;
  const FigureContent content = read_figure(run.run(), {});
  const std::vector<FigureNumbers>& numbers = content.strips[0].numbers;
  EXPECT_THAT(texts_of(numbers[0].errors), ElementsAre("reference"));
  EXPECT_THAT(texts_of(numbers[0].costs), ElementsAre("300.0 ms", "2.0 MB"));
  EXPECT_THAT(texts_of(numbers[1].errors), ElementsAre("SSIM 0.9900*", "RMSE 0.0100*"));
  EXPECT_THAT(texts_of(numbers[1].costs), ElementsAre("200.0 ms", "2.0 MB*"));
  EXPECT_THAT(texts_of(numbers[2].errors), ElementsAre("SSIM 0.7500", "RMSE 0.250"));
  EXPECT_THAT(texts_of(numbers[2].costs), ElementsAre("100.0 ms", "2.0 MB*"));  // of one time
}

TEST(UnitFigureNumbers, IntervalsThatOverlapAreTies) {
  FigureRun run;
  for (ResultRow& row : run.run().rows)
    row.seconds.interval = {row.seconds.median - 0.06, row.seconds.median + 0.06};
  const FigureContent content = read_figure(run.run(), {});
  EXPECT_THAT(texts_of(content.strips[0].numbers[1].costs), ElementsAre("200.0 ms*^*", "2.0 MB*"));
  EXPECT_THAT(texts_of(content.strips[0].numbers[2].costs), ElementsAre("100.0 ms*", "2.0 MB*"));
}

TEST(UnitFigureNumbers, OneThatIsAloneIsNotTheBest) {
  FigureRun run;
  const FigureContent content = read_figure(run.run(), of_methods({"truth", "far"}));
  EXPECT_THAT(texts_of(content.strips[0].numbers[1].costs), ElementsAre("100.0 ms", "2.0 MB"));
}

TEST(UnitFigureNumbers, ErrorsBelowAThousandthHaveAnExponent) {
  FigureRun run;
  run.run().rows[1].metrics.linear.of("rmse") = 1.26e-4;
  FigureRequest request;
  request.numbers = {"rmse"};
  const FigureContent content = read_figure(run.run(), request);
  EXPECT_EQ(text_of(content.strips[0].numbers[1].errors[0]), "RMSE 1.26·10*^-4*");
}

TEST(UnitFigureContent, TheMapsAreOfTheReferenceThoughItIsNoColumn) {
  FigureRun run;
  FigureRequest request = of_methods({"far"});
  request.errors = request.flips = true;
  const FigureContent content = read_figure(run.run(), request);
  ASSERT_EQ(content.strips[0].lines_of_maps.size(), 2u);
  const FigureMaps& errors = content.strips[0].lines_of_maps[0];
  ASSERT_EQ(errors.maps.size(), 1u);
  // 0.25 lies at log(250) / log(1000) of the scale.
  const Rgba expected = errors.scale.colors.at(int(256 * 2.39794 / 3), 0);
  for (int channel = 0; channel < 3; ++channel)
    EXPECT_NEAR(errors.maps[0].at(3, 5)[channel], expected[channel], 0.02);
  request = {};
  request.errors = true;
  const FigureContent whole = read_figure(run.run(), request);
  EXPECT_TRUE(whole.strips[1].lines_of_maps[0].maps[0].pixels.empty());
  EXPECT_EQ(whole.strips[1].lines_of_maps[0].maps[1].width, 20);
}

TEST(UnitFigureContent, WithoutACropTheMostDifferentPartIsEnlarged) {
  FigureRun run;
  Image spot = testing::ramp(40, 20, 0.25f);
  spot.at(33, 12).b = 0.75f;
  write_image(run.picture(1), spot, {});
  FigureRequest request = of_methods({"truth,near"});
  request.scenes = {"a"};
  const std::vector<Crop> crops = read_figure(run.run(), request).strips[0].crops;
  ASSERT_EQ(crops.size(), 1u);
  EXPECT_EQ(crops[0].width, 10);
  EXPECT_EQ(crops[0].height, 5);
  EXPECT_TRUE(crops[0].x <= 33 && 33 < crops[0].x + 10 && crops[0].y <= 12 && 12 < crops[0].y + 5);
  request.own_crops = false;
  EXPECT_TRUE(read_figure(run.run(), request).strips[0].crops.empty());
}

TEST(UnitFigureContent, WhatIsWrongIsNamed) {
  FigureRun run;
  FigureRequest request;
  request.scenes = {"aa"};
  EXPECT_THAT(refusal(run, request), HasSubstr("--scene: unknown scene 'aa'; known: a, b"));
  EXPECT_THAT(refusal(run, of_methods({"nearer"})),
              HasSubstr("--methods: unknown method 'nearer'; known: near, far, truth"));
  request = {};
  request.crops = {{"", {30, 0, 11, 5}}};
  EXPECT_THAT(refusal(run, request), AllOf(HasSubstr("--crop 30,0,11,5"), HasSubstr("40×20")));
  request.crops = {{"c", {0, 0, 5, 5}}};
  EXPECT_THAT(refusal(run, request), HasSubstr("'c' is no scene of the figure"));
  request = {};
  request.labels = {"one", "two"};
  EXPECT_THAT(refusal(run, request), HasSubstr("--label: 2 are given; accepted: 3"));
  request = {};
  request.numbers = {"rsme"};
  EXPECT_THAT(refusal(run, request), HasSubstr("unknown column 'rsme'; known: rmse"));
  run.run().rows[5].error = "no memory";
  EXPECT_THAT(refusal(run, {}), HasSubstr("b/far failed: no memory"));
  EXPECT_EQ(refusal(run, of_methods({"truth,near"})), "");
  run.run().rows[3].error = "no memory";
  request = of_methods({"near"});
  request.errors = true;
  EXPECT_THAT(refusal(run, request), HasSubstr("the reference of b has no picture"));
  run.run().rows.erase(run.run().rows.begin() + 4);
  EXPECT_THAT(refusal(run, of_methods({"near"})), HasSubstr("has no cell b/near"));
}

TEST(UnitFigureContent, MissingPicturesAndOthersOfAnotherSizeAreNamed) {
  FigureRun run;
  write_image(run.picture(1), testing::ramp(39, 20, 0), {});
  EXPECT_THAT(refusal(run, {}), AllOf(HasSubstr("near.exr: 39×20"), HasSubstr("40×20")));
  std::filesystem::remove(run.picture(1));
  EXPECT_THAT(refusal(run, {}), HasSubstr("near.exr: is missing"));
}

}  // namespace
}  // namespace pellucid::compare
