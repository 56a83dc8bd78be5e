// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/figure/plots/plot_layout.h"

#include <gmock/gmock.h>

#include <cstdlib>

#include "compare/figure/plots/write_plot.h"
#include "core/error.h"
#include "core/files/output_file.h"
#include "tests/compare/figure/figure_runs.h"

namespace pellucid::compare {
namespace {

using testing::FigureRun;
using ::testing::HasSubstr;

/// Every byte half as wide as high.
double half_width(const std::vector<TextRun>& runs, double size) {
  double width = 0;
  for (const TextRun& run : runs) width += 0.5 * size * double(run.text.size());
  return width;
}

Plot two_panels() {
  const PlotSeries first{"first", {{1, 0.5}, {10, 0.1}}}, second{"second", {{100, 0}}, true};
  return {{"Time [ms]", true},
          {"RMSE", true, 1e-7},
          {{"a", {first, second}, {{1, 0.5}, {10, 0.1}}, {50}}, {"b", {second}, {}, {}}},
          "exact"};
}

std::vector<const SheetLine*> marks(const FigureSheet& sheet) {
  std::vector<const SheetLine*> filled;
  for (const SheetLine& line : sheet.lines)
    if (line.is_filled) filled.push_back(&line);
  return filled;
}

TEST(UnitPlotLayout, AllOfItIsOnTheSheet) {
  for (const double width : {180.0, 252.0, 500.0}) {
    const FigureSheet sheet = lay_out_plot(two_panels(), width, 8, half_width);
    for (const SheetLine& line : sheet.lines)
      for (const Vec2& point : line.points) {
        EXPECT_GE(point.x, 0) << width;
        EXPECT_LE(point.x, sheet.width) << width;
        EXPECT_GE(point.y, 0) << width;
        EXPECT_LE(point.y, sheet.height) << width;
      }
    for (const SheetText& text : sheet.texts) {
      const double half = text.is_turned ? 0 : half_width(text.runs, text.size) / 2;
      EXPECT_GE(text.at.x - half, -1e-9) << text.runs[0].text << ' ' << width;
      EXPECT_LE(text.at.x + half, sheet.width + 1e-9) << text.runs[0].text << ' ' << width;
      EXPECT_LE(text.at.y, sheet.height) << text.runs[0].text;
    }
  }
}

TEST(UnitPlotLayout, ASeriesLooksTheSameInEveryPanelAndInTheLegend) {
  const FigureSheet sheet = lay_out_plot(two_panels(), 500, 8, half_width);
  const auto filled = marks(sheet);
  // Two of the first, one of the second in either panel, and one each in the legend.
  ASSERT_EQ(filled.size(), 6u);
  EXPECT_EQ(filled[0]->color, filled[1]->color);
  EXPECT_NE(filled[0]->color, filled[2]->color);
  EXPECT_EQ(filled[2]->color, filled[3]->color);
  EXPECT_EQ(filled[2]->points.size(), filled[3]->points.size());
  EXPECT_EQ(filled[4]->color, filled[0]->color);
  EXPECT_EQ(filled[5]->color, filled[2]->color);
}

TEST(UnitPlotLayout, PanelsStandSideBySideWhereThereIsRoom) {
  EXPECT_GT(lay_out_plot(two_panels(), 250, 8, half_width).height,
            1.3 * lay_out_plot(two_panels(), 300, 8, half_width).height);
}

TEST(UnitPlotLayout, WithoutRoomForAxesItIsRefused) {
  EXPECT_THROW(lay_out_plot(two_panels(), 60, 8, half_width), InputError);
}

TEST(UnitPlotFiles, APdfHasItsTextAndACsvItsPoints) {
  FigureRun run;
  write_plot(run.file("plot.csv"), run.run(), {}, {});
  EXPECT_THAT(read_text(run.file("plot.csv")), HasSubstr("a,far,100,0.25\n"));
  const WrittenFigure written = write_plot(run.file("plot.pdf"), run.run(), {}, {});
  EXPECT_NEAR(written.width, figure_widths().front().millimetres / 25.4 * 72, 1e-9);
  if (std::system("command -v pdftotext >/dev/null") != 0) GTEST_SKIP() << "no pdftotext";
  const auto text = run.file("plot.txt");
  ASSERT_EQ(
      std::system(
          ("pdftotext -layout " + run.file("plot.pdf").string() + ' ' + text.string()).c_str()),
      0);
  EXPECT_THAT(read_text(text), HasSubstr("Time [ms]"));
  EXPECT_THAT(read_text(text), HasSubstr("truth, the reference"));
}

TEST(UnitPlotFiles, OtherEndingsAreRefused) {
  FigureRun run;
  EXPECT_THROW(write_plot(run.file("plot.tex"), run.run(), {}, {}), InputError);
}

}  // namespace
}  // namespace pellucid::compare
