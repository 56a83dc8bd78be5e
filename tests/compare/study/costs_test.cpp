// SPDX-License-Identifier: GPL-3.0-or-later
// Costs step by step beside the source's: made-up rows with known bottlenecks and ratios.

#include "compare/study/costs.h"

#include <gmock/gmock.h>

#include "compare/report/tables.h"
#include "tests/compare/fake_methods.h"
#include "tests/compare/study_error.h"
#include "tests/compare/study_folder.h"

namespace pellucid::compare {
namespace {

using namespace testing;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Optional;

ResultRow cost_row(const std::string& scene, const std::string& method, bool reference,
                   const std::vector<std::pair<std::string, double>>& steps) {
  ResultRow row;
  row.scene = scene;
  row.method = method;
  row.reference = reference;
  row.bytes = {{"all", 2'000'000}};
  for (const auto& [name, seconds] : steps) {
    row.steps.push_back({name, {seconds, seconds, seconds}});
    row.seconds.median += seconds;
  }
  return row;
}

const std::vector<ResultRow> cost_rows{
    cost_row("one", "truth", true, {{"build", 0.5}, {"sort", 1.5}}),
    cost_row("one", "series", false, {{"project", 0.125}, {"weight", 0.25}, {"project", 0.25}}),
    cost_row("two", "series", false, {{"weight", 0.5}})};

Study study_with(PublishedCosts published) {
  Study study;
  study.scenes = {"one.json", "two.json"};
  const scene::MethodRow& truth = fake_methods().front();
  study.reference = {&truth, Parameters(truth.name, truth.parameters, {})};
  study.published = std::move(published);
  return study;
}

const PublishedCosts published{
    "a GPU", {"1", "2"}, {{"one", "truth", 60, 5e6, {}}, {"one", "series", 20, {}, {15, 5}}}};

TEST(UnitCosts, StepsOfOneNameAddUpAndTheLongestIsTheBottleneck) {
  const auto tables = cost_tables(study_with(published), cost_rows);
  ASSERT_EQ(tables.size(), 3u);  // truth, series, the source
  const CostTable& series = tables[1];
  EXPECT_THAT(series.steps, ElementsAre("project", "weight"));
  EXPECT_THAT(series.lines[0].steps, ElementsAre(Optional(375.0), Optional(250.0)));
  EXPECT_EQ(series.lines[0].bottleneck, 0u);
  EXPECT_THAT(series.lines[0].milliseconds, Optional(625.0));
  // One step alone is no bottleneck; a step that a line lacks is not 0.
  EXPECT_THAT(series.lines[1].steps, ElementsAre(std::nullopt, Optional(500.0)));
  EXPECT_EQ(series.lines[1].bottleneck, std::nullopt);
  EXPECT_EQ(tables[2].lines[1].bottleneck, 0u);
  EXPECT_EQ(tables[2].lines[0].bottleneck, std::nullopt);
}

TEST(UnitCosts, RatiosAreTheReferencesTimeOverTheMethods) {
  const auto ratios = cost_ratios(study_with(published), cost_rows);
  ASSERT_EQ(ratios.size(), 1u);  // two has no reference
  EXPECT_THAT(ratios[0].here, Optional(3.2));
  EXPECT_THAT(ratios[0].published, Optional(3.0));
}

TEST(UnitCosts, TablesMarkTheBottleneck) {
  const Study study = study_with(published);
  EXPECT_THAT(markdown_table(study, cost_rows),
              HasSubstr("| one | series | 2.0 | 625 | **375** | 250 |"));
  EXPECT_THAT(latex_table(study, cost_rows),
              HasSubstr("one & series & 2.0 & 625 & \\textbf{375} & 250 \\\\"));
  EXPECT_THAT(csv_costs(study, cost_rows),
              HasSubstr("\"As published, on a GPU\",one,series,1,15\n"));
  Study without = study;
  without.published.reset();
  EXPECT_THAT(markdown_costs(without, cost_rows), IsEmpty());
  EXPECT_THAT(latex_costs(without, cost_rows), IsEmpty());
}

/// Nobody told how long it took: that is neither 0 nor infinitely fast.
TEST(UnitCosts, ATimeThatIsNotKnownIsEmpty) {
  ResultRow theirs = cost_row("one", "theirs", false, {});
  theirs.given = "picture";
  std::vector<ResultRow> rows = cost_rows;
  rows.push_back(theirs);
  const Study study = study_with(published);
  EXPECT_EQ(cost_tables(study, rows)[2].lines[0].milliseconds, std::nullopt);
  EXPECT_EQ(cost_ratios(study, rows)[1].here, std::nullopt);
  EXPECT_THAT(csv_costs(study, rows), HasSubstr("\"theirs, here\",one,theirs,total,\n"));
  EXPECT_THAT(markdown_costs(study, rows), HasSubstr("| one | theirs | 2.0 | – |\n"));
  EXPECT_THAT(markdown_costs(study, rows), HasSubstr("| one | theirs | – | – |\n"));
  EXPECT_THAT(latex_costs(study, rows), HasSubstr("one & theirs & 2.0 & – \\\\"));
}

std::string costs_error(const std::string& costs) {
  return study_error(
      R"(["broken"])",
      R"("published": {"machine": "a GPU", "steps": ["1", "2"], "rows": [)" + costs + "]}");
}

TEST(UnitCosts, AStudyGivesCostsOfItsOwnScenesAndCalls) {
  EXPECT_EQ(costs_error(R"({"scene": "one", "method": "broken", "ms": 5, "steps": [2, 3]})"),
            "no error");
  EXPECT_THAT(costs_error(R"({"scene": "three", "method": "broken", "ms": 5})"),
              HasSubstr("published.rows[0].scene: unknown scene 'three'"));
  EXPECT_THAT(costs_error(R"({"scene": "one", "method": "shifted", "ms": 5})"),
              HasSubstr("unknown call 'shifted'"));
  EXPECT_THAT(costs_error(R"({"scene": "one", "method": "broken", "ms": 0})"),
              HasSubstr("published.rows[0].ms"));
  EXPECT_THAT(costs_error(R"({"scene": "one", "method": "broken", "ms": 5, "steps": [5]})"),
              HasSubstr("one for each of the 2 steps"));
}

}  // namespace
}  // namespace pellucid::compare
