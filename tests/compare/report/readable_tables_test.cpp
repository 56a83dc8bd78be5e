// SPDX-License-Identifier: GPL-3.0-or-later
// The tables for people, whatever names files hold.
#include <gmock/gmock.h>

#include <array>
#include <sstream>
#include <vector>

#include "compare/report/budget_tables.h"
#include "compare/report/tables.h"
#include "tests/compare/fake_methods.h"

namespace pellucid::compare {
namespace {

using namespace testing;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string evil = "a|b <i> & c\nd";
const std::string escaped = "a\\|b &lt;i> &amp; c\\nd";

/// Rows whose names are evil in all tables.
std::array<ResultRow, 2> evil_rows() {
  std::array<ResultRow, 2> rows;
  for (ResultRow& row : rows) {
    row.scene = "one";
    row.method = evil;
    row.machine = {{"cpu", evil}};
    row.bytes = {{"all", 2'000'000}};
    row.steps = {{evil, {1, 1, 1}}, {"other", {2, 2, 2}}};
    row.measures = {{"m", evil, "", 0.5}};
    BudgetLine mesh, field;
    mesh.stage = "mesh";
    mesh.refinement = evil;
    field.stage = "field";
    field.why_not = evil;
    row.budget = {.rmse = 0.5, .seconds = 2, .interaction = 0.25, .lines = {mesh, field}};
  }
  rows[0].reference = true;
  rows[1].machine = {{"cpu", "other"}};
  rows[1].given = "picture";
  rows[1].given_faults = {evil};
  return rows;
}

Study evil_study() {
  Study study;
  study.title = study.source = evil;
  study.notes = {evil};
  study.scenes = {"one.json"};
  const scene::MethodRow& truth = fake_methods().front();
  study.reference = {&truth, Parameters(truth.name, truth.parameters, {})};
  study.published = PublishedCosts{evil, {evil}, {{"one", evil, 60, 5e6, {60}}}};
  Claim claim;
  claim.text = evil;
  claim.by.measure = "m";
  claim.order = {{evil}};
  claim.bound = 1;
  study.claims = {claim};
  return study;
}

/// Of the marks between cells those that are not escaped.
std::size_t cells_of(const std::string& line) {
  std::size_t marks = 0;
  for (std::size_t i = 0; i < line.size(); ++i)
    marks += line[i] == '|' && (i == 0 || line[i - 1] != '\\');
  return marks;
}

TEST(UnitReadableTables, NamesAreEscapedWhereverTheyStand) {
  const std::string text = markdown_table(evil_study(), evil_rows());
  EXPECT_THAT(text, AllOf(Not(HasSubstr("<i")), Not(HasSubstr("b & c")), Not(HasSubstr("& c\nd"))));
  for (const std::string& place : std::vector<std::string>{
           "# " + escaped, "| " + escaped + " (given) |", "| | " + escaped + " |",
           "\n" + escaped + " (m):", "- one: " + escaped, "## " + escaped + ", here",
           "on " + escaped, "| " + escaped + " |\n", "field: not here: ", "one/" + escaped})
    EXPECT_THAT(text, HasSubstr(place));
}

TEST(UnitReadableTables, EveryLineOfATableHasAsManyCells) {
  std::istringstream lines(markdown_table(evil_study(), evil_rows()));
  std::size_t before = 0;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t here = line.starts_with('|') ? cells_of(line) : 0;
    EXPECT_TRUE(before == 0 || here == 0 || here == before) << line;
    before = here;
  }
}

TEST(UnitReadableTables, LatexHasTheWarningsAsComments) {
  std::array<ResultRow, 2> rows = evil_rows();
  rows[1].measures.push_back({"views", "Views", "", 4});
  std::istringstream lines(latex_table(evil_study(), rows));
  std::string head;
  for (std::string line; std::getline(lines, line) && line.starts_with('%');) head += line + '\n';
  EXPECT_THAT(head, AllOf(HasSubstr("% Warning: The rows come from 2 machines"),
                          HasSubstr("the picture a|b <i> & c\\nd."),
                          HasSubstr("% Numbers are means over 4 views.")));
}

}  // namespace
}  // namespace pellucid::compare
