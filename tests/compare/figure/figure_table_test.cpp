// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/figure/figure_table.h"

#include <gmock/gmock.h>

#include "compare/figure/write_figure.h"
#include "core/error.h"
#include "core/files/output_file.h"
#include "tests/compare/figure/figure_runs.h"

namespace pellucid::compare {
namespace {

using ::testing::AllOf;
using testing::FigureRun;
using ::testing::HasSubstr;
using ::testing::Not;

std::string table_of(FigureRun& run, const FigureRequest& request) {
  return latex_figure_table(find_figure_rows(run.run(), request), request, width_of_text("eg"),
                            {"50 % of a_b", "t", "command"});
}

TEST(UnitFigureTable, HasMeasuresOfRowsToo) {
  FigureRun run;
  for (ResultRow& row : run.run().rows)
    if (row.scene == "a" && !row.reference)
      row.measures = {{"rmse_worst", "RMSE, worst view", "", 2 * *row.metrics.linear.of("rmse"),
                       Better::lower}};
  FigureRequest request;
  request.numbers = {"rmse_worst"};
  const std::string text = table_of(run, request);
  EXPECT_THAT(text, HasSubstr("Method & RMSE, worst view"));
  EXPECT_THAT(text, AllOf(HasSubstr("near & {\\boldmath\\textbf{0.0200}}"),
                          HasSubstr("far & 0.500"), HasSubstr("near & --")));
  request.numbers = {"rmse_wrost"};
  EXPECT_THROW(table_of(run, request), InputError);
}

TEST(UnitFigureTable, TheBestIsBoldTiesHaveAStarAndTheReferenceHasNoErrors) {
  FigureRun run;
  for (ResultRow& row : run.run().rows)
    row.seconds.interval = {row.seconds.median - 0.06, row.seconds.median + 0.06};
  FigureRequest request;
  request.scenes = {"a"};
  request.numbers = {"rmse", "seconds"};
  const std::string text = table_of(run, request);
  EXPECT_THAT(text,
              HasSubstr("\\textit{truth} & -- & 300.0 {\\footnotesize(240.0--360.0)} \\\\\n"));
  EXPECT_THAT(text,
              HasSubstr("near & {\\boldmath\\textbf{0.0100}} & {\\boldmath\\textbf{200.0}}$^*$ "
                        "{\\footnotesize(140.0--260.0)} \\\\\n"));
  EXPECT_THAT(text, HasSubstr("far & 0.250 & {\\boldmath\\textbf{100.0}} {\\footnotesize"));
  EXPECT_THAT(text, AllOf(HasSubstr("\\begin{table}[t]"), HasSubstr("Method & RMSE & Time [ms]"),
                          HasSubstr("\\caption{50 \\% of a\\_b}"), HasSubstr("{lrr}"),
                          Not(HasSubstr("multicolumn"))));
}

TEST(UnitFigureTable, ExponentsAreMathematics) {
  FigureRun run;
  run.run().rows[1].metrics.linear.of("rmse") = 1.26e-4;
  FigureRequest request;
  request.numbers = {"rmse"};
  EXPECT_THAT(table_of(run, request), HasSubstr("1.26$\\cdot$10$^{-4}$"));
}

TEST(UnitFigureTable, SaysWhatTheTablesOfTheRunSay) {
  FigureRun run;
  for (ResultRow& row : run.run().rows) row.measures = {{"views", "Views", "", 4}};
  run.run().rows[1].given_faults = {"looks upside down"};
  FigureRequest request;
  request.numbers = {"rmse"};
  write_figure_table(run.file("t.tex"), run.run(), request, {}, "command");
  EXPECT_THAT(read_text(run.file("t.tex")),
              AllOf(HasSubstr("% command\n% Warning: a/near: the picture looks upside down.\n"),
                    HasSubstr("Numbers are means over 4 views.}")));
}

/// 12 and 2604 are no reals of three digits.
TEST(UnitFigureTable, CountsHaveAllTheirDigits) {
  FigureRun run;
  double count = 11;
  for (ResultRow& row : run.run().rows)
    if (!row.reference) row.measures = {{"kept", "Kept lines", "", ++count, Better::lower}};
  FigureRequest request;
  request.numbers = {"kept"};
  EXPECT_THAT(table_of(run, request), HasSubstr("near & {\\boldmath\\textbf{12}}"));
  run.run().rows[1].measures[0].value = 2603.5;  // a mean over views is none
  EXPECT_THAT(table_of(run, request), HasSubstr("near & 2604"));
}

TEST(UnitFigureTable, ScenesAreBlocksAndLabelsAreEscaped) {
  FigureRun run;
  FigureRequest request;
  request.methods = {"near,far"};
  request.labels = {"N & M", "F"};
  request.scene_labels = {"A_1", "B"};
  const std::string text = table_of(run, request);
  EXPECT_THAT(text, AllOf(HasSubstr("\\multicolumn{5}{l}{\\textit{A\\_1}}"),
                          HasSubstr("\\multicolumn{5}{l}{\\textit{B}}"), HasSubstr("N \\& M & ")));
  request.numbers = {"rsme"};
  EXPECT_THROW(table_of(run, request), InputError);
}

}  // namespace
}  // namespace pellucid::compare
