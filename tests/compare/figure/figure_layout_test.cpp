// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/figure/figure_layout.h"

#include <gmock/gmock.h>

#include "compare/figure/fitted_text.h"
#include "core/error.h"
#include "tests/compare/figure/figure_runs.h"

namespace pellucid::compare {
namespace {

using ::testing::ElementsAre;
using testing::FigureRun;

/// Every byte half as wide as high.
double half_width(const std::vector<TextRun>& runs, double size) {
  double width = 0;
  for (const TextRun& run : runs) width += 0.5 * size * double(run.text.size());
  return width;
}

FigureRequest with_crop(const Crop& crop) {
  FigureRequest request;
  request.scenes = {"a"};
  request.crops = {{"", crop}};
  return request;
}

FigureSheet sheet_of(FigureRun& run, const FigureRequest& request, double width = 300) {
  return lay_out(read_figure(run.run(), request), width, 8, half_width);
}

bool is_frame_of(const SheetLine& line, double x, double y, double width, double height) {
  return line.is_closed && std::abs(line.points[0].x - x) < 1e-9 &&
         std::abs(line.points[0].y - y) < 1e-9 && std::abs(line.points[2].x - x - width) < 1e-9 &&
         std::abs(line.points[2].y - y - height) < 1e-9;
}

TEST(UnitFigureLayout, ColumnsOfOneWidthFillTheSheet) {
  FigureRun run;
  FigureRequest request = with_crop({});
  request.crops.clear();
  request.own_crops = false;
  const FigureSheet sheet = sheet_of(run, request);
  ASSERT_EQ(sheet.pictures.size(), 3u);
  // Two gaps of 3 and margins of 1 leave 292.
  for (const SheetPicture& picture : sheet.pictures) {
    EXPECT_NEAR(picture.box.width, 292.0 / 3, 1e-9);
    EXPECT_NEAR(picture.box.height, 292.0 / 6, 1e-9);
    EXPECT_FALSE(picture.is_enlarged);
  }
  EXPECT_NEAR(sheet.pictures[0].box.x, 1, 1e-9);
  EXPECT_NEAR(sheet.pictures[2].box.right(), 299, 1e-9);
}

TEST(UnitFigureLayout, AnInsetHoldsTheCropsPixelsAndIsJoinedToIt) {
  FigureRun run;
  const Crop crop{12, 4, 16, 8};
  const FigureSheet sheet = sheet_of(run, with_crop(crop));
  ASSERT_EQ(sheet.pictures.size(), 6u);
  const SheetPicture &whole = sheet.pictures[2], &inset = sheet.pictures[3];
  EXPECT_TRUE(inset.is_enlarged);
  const Image exr = read_image(run.picture(1));
  for (int y = 0; y < crop.height; ++y)
    for (int x = 0; x < crop.width; ++x)
      EXPECT_EQ(inset.image.at(x, y), exr.at(crop.x + x, crop.y + y));
  EXPECT_NEAR(inset.box.width, whole.box.width, 1e-9);
  EXPECT_NEAR(inset.box.height, whole.box.width / 2, 1e-9);
  const double pixel = whole.box.width / 40;
  const double x = whole.box.x + 12 * pixel, y = whole.box.y + 4 * pixel;
  EXPECT_TRUE(std::ranges::any_of(sheet.lines, [&](const SheetLine& line) {
    return is_frame_of(line, x, y, 16 * pixel, 8 * pixel);
  }));
  EXPECT_TRUE(std::ranges::any_of(sheet.lines, [&](const SheetLine& line) {
    return !line.is_closed && glm::length(line.points[0] - Vec2(x, y + 8 * pixel)) < 1e-9 &&
           glm::length(line.points[1] - Vec2(inset.box.x, inset.box.y)) < 1e-9;
  }));
}

TEST(UnitFigureLayout, InsetsBesideEachOtherAreOfOneHeight) {
  FigureRun run;
  FigureRequest request = with_crop({0, 0, 10, 10});
  request.crops.push_back({"a", {5, 5, 20, 10}});
  const FigureSheet sheet = sheet_of(run, request);
  ASSERT_EQ(sheet.pictures.size(), 9u);
  const SheetBox &whole = sheet.pictures[0].box, &one = sheet.pictures[1].box,
                 &two = sheet.pictures[2].box;
  EXPECT_NEAR(one.height, two.height, 1e-9);
  EXPECT_NEAR(two.width, 2 * one.width, 1e-9);
  EXPECT_NEAR(one.x, whole.x, 1e-9);
  EXPECT_NEAR(two.right(), whole.right(), 1e-9);
  EXPECT_NEAR(two.x - one.right(), 2, 1e-9);
}

/// 60 gaps of 2 are wider than a column of 97.
TEST(UnitFigureLayout, MoreInsetsThanFitAreRefused) {
  FigureRun run;
  FigureRequest request = with_crop({0, 0, 10, 10});
  request.crops.resize(60, request.crops.front());
  EXPECT_THROW(sheet_of(run, request), InputError);
}

TEST(UnitFigureLayout, TheScaleStandsWhereTheReferenceHasNoMap) {
  FigureRun run;
  FigureRequest request;
  request.errors = true;
  request.own_crops = false;
  const FigureSheet sheet = sheet_of(run, request);
  // Per scene three pictures, two maps, a scale.
  ASSERT_EQ(sheet.pictures.size(), 12u);
  const SheetBox &first = sheet.pictures[0].box, &map = sheet.pictures[3].box,
                 &bar = sheet.pictures[5].box;
  EXPECT_NEAR(map.x, sheet.pictures[1].box.x, 1e-9);
  EXPECT_NEAR(map.y, first.bottom() + 3, 1e-9);
  EXPECT_NEAR(bar.middle(), first.middle(), 1e-9);
  EXPECT_NEAR(bar.y + bar.height / 2, map.y + map.height / 2, 1e-9);
  request.methods = {"near,far"};
  const FigureSheet below = sheet_of(run, request);
  ASSERT_EQ(below.pictures.size(), 9u);
  EXPECT_GT(below.pictures[8].box.y, below.pictures[7].box.bottom());
  EXPECT_NEAR(below.pictures[8].box.middle(), 150, 1e-9);
}

TEST(UnitFigureLayout, NumbersLieBelowEachOtherWhereTheyAreTooWideForOneLine) {
  FigureRun run;
  FigureRequest request = with_crop({0, 0, 4, 4});
  request.numbers = {"ssim", "rmse"};
  // Eleven bytes of 6.8 points half as wide, and a space: 41.5 points each.
  const auto heights = [&](double width) {
    const FigureSheet sheet = sheet_of(run, request, width);
    std::set<double> all;
    for (const SheetText& text : sheet.texts)
      if (text.size < 8) all.insert(text.at.y);
    return all.size();
  };
  EXPECT_EQ(heights(8 + 3 * 85), 1u);
  EXPECT_EQ(heights(8 + 3 * 81), 2u);
}

TEST(UnitFigureLayout, AColumnThatIsTooNarrowIsRefused) {
  FigureRun run;
  EXPECT_THROW(sheet_of(run, with_crop({0, 0, 4, 4}), 57), InputError);
  EXPECT_NO_THROW(sheet_of(run, with_crop({0, 0, 4, 4}), 120));
}

TEST(UnitFittedText, WhatIsTooWideEndsWithAnEllipsisBetweenCharacters) {
  const TextRuler one_each = [](const std::vector<TextRun>& runs, double) {
    return double(std::ranges::count_if(runs[0].text, [](char c) { return (c & 0xC0) != 0x80; }));
  };
  EXPECT_EQ(fitted("größer", 1, 6, one_each), "größer");
  EXPECT_EQ(fitted("größer", 1, 4, one_each), "grö…");
  EXPECT_EQ(fitted("a\nb\xff", 1, 9, one_each), "a\\nb\uFFFD");
  EXPECT_THAT(wrapped("one two three", 1, 7, 2, one_each), ElementsAre("one two", "three"));
  EXPECT_THAT(wrapped("one two three", 1, 5, 2, one_each), ElementsAre("one", "two …"));
  EXPECT_THAT(wrapped("unbreakable", 1, 5, 2, one_each), ElementsAre("unbr…"));
  EXPECT_TRUE(wrapped("", 1, 5, 2, one_each).empty());
}

}  // namespace
}  // namespace pellucid::compare
