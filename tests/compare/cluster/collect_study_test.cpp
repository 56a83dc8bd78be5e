// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cluster/collect_study.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <thread>

#include "compare/results/provenance.h"
#include "core/files/json_text.h"
#include "tests/compare/cluster/cells.h"

namespace pellucid::compare::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr const char* all_kinds = R"(["shifted:by=0.5", {"method": "shifted", "by": [0.25, 0.75]},
                                      "exact-shifted", "measuring", "layering", "broken"])";

std::vector<std::string> names_of(const std::vector<MissingCell>& missing) {
  std::vector<std::string> names;
  for (const MissingCell& cell : missing) names.push_back(cell.text());
  return names;
}

/// Whatever the study asks for: the rows of a study in one run, and cell by cell in the same place,
/// which rows name, from the last to the first of each scene but for its reference.
void expect_equal_rows(const CellByCell& cells) {
  const StudyOutcome expected = run_study(cells.study, cells.options);
  const fs::path whole = cells.folder / "whole";
  fs::rename(cells.options.folder, whole);
  std::vector<PlannedCell> plan = plan_study(cells.study, cells.options);
  for (const PlannedCell& planned : plan)
    if (planned.needs.empty()) cells.compute(planned.cell);
  for (auto planned = plan.rbegin(); planned != plan.rend(); ++planned)
    if (!planned->needs.empty()) cells.compute(planned->cell);
  const Collection collected = cells.collect();
  EXPECT_TRUE(collected.missing.empty());
  ASSERT_EQ(collected.rows.size(), expected.rows.size());
  for (std::size_t i = 0; i < expected.rows.size(); ++i)
    EXPECT_EQ(without_times(collected.rows[i]), without_times(expected.rows[i]));
  EXPECT_EQ(read_text(cells.options.folder / "table.tex"), read_text(whole / "table.tex"));
  for (const auto& entry : fs::recursive_directory_iterator(whole / "images")) {
    const fs::path name = fs::relative(entry.path(), whole);
    if (entry.is_directory()) continue;
    EXPECT_EQ(read_text(entry.path()), read_text(cells.options.folder / name)) << name;
  }
}

TEST(UnitCollect, CellByCellTheRowsAndPicturesAreTheSame) {
  expect_equal_rows(CellByCell(all_kinds));
}

TEST(UnitCollect, TheyAreFromEveryView) {
  expect_equal_rows(CellByCell(all_kinds, R"("repeats": 1, "views": 2)"));
}

TEST(UnitCollect, TheReferenceMayDrawASceneOfItsOwn) {
  const CellByCell cells(all_kinds, R"("repeats": 1, "reference_scene": "two.json")");
  write_scene(cells.folder / "two.json", 24, 16);  // as one.json, so that the pictures compare
  expect_equal_rows(cells);
}

TEST(UnitCollect, WhatIsMissingIsNamedAndTheRestIsThere) {
  CellByCell cells;
  cells.compute("one/truth");
  cells.compute("one/shifted:by=0.5");
  cells.compute("two/truth");
  write_scene(cells.folder / "two.json", 13, 41);
  const Collection collection = cells.collect();
  EXPECT_EQ(collection.rows.size(), 2u);
  EXPECT_THAT(names_of(collection.missing),
              ElementsAre("one/exact-shifted", "two/truth (there, but of other inputs)",
                          "two/shifted:by=0.5", "two/exact-shifted"));
  EXPECT_THAT(read_text(cells.folder / "results/table.md"), HasSubstr("shifted:by=0.5"));
  EXPECT_TRUE(fs::exists(cells.folder / "results/report.html"));
}

// A full disk, a kill or a bad cable: the report is of the rest.
TEST(UnitCollect, WhatIsWrongWithACellThatIsThereIsSaid) {
  const CellByCell cells;
  const std::vector<std::string> names = {"one/truth", "one/shifted:by=0.5", "one/exact-shifted",
                                          "two/truth", "two/shifted:by=0.5", "two/exact-shifted"};
  for (const std::string& cell : names) cells.compute(cell);
  const fs::path results = cells.folder / "results";
  const std::string picture = read_text(results / "images/one/truth.exr");
  write_text(results / "images/one/truth.exr", picture.substr(0, picture.size() / 2));
  write_text(results / "images/one/exact-shifted.error.png", "");
  write_text(results / "cells/two/truth.json", "{");
  fs::remove(results / "images/two/shifted-by-0.5.png");
  const Collection collection = cells.collect();
  EXPECT_THAT(names_of(collection.missing),
              ElementsAre("one/truth (there, but truth.exr is not as it was made)",
                          "one/exact-shifted (there, but exact-shifted.error.png is empty)",
                          "two/truth (there, but truth.json is no whole row)",
                          "two/shifted:by=0.5 (there, but shifted-by-0.5.png is gone)"));
  EXPECT_EQ(collection.rows.size(), 2u);
  for (const MissingCell& cell : collection.missing) EXPECT_EQ(cells.compute(cell.cell).error, "");
  EXPECT_TRUE(cells.collect().missing.empty());
}

// Earlier builds kept the names of the files alone.
TEST(UnitCollect, ARowThatListsNamesHoldsWhileTheyAreThere) {
  const CellByCell cells;
  cells.compute("one/truth");
  const fs::path file = cells.folder / "results/cells/one/truth.json";
  const fs::path layers = cells.folder / "results/images/one/truth.layers.exr";
  nlohmann::json row = read_json(file);
  row["files"] = {"truth.exr", "truth.png", "truth.layers.exr"};
  write_text(file, row.dump());
  EXPECT_EQ(cells.collect().rows.size(), 1u);
  fs::remove(layers);
  EXPECT_THROW(cells.collect(), WorkError);
}

TEST(UnitCollect, WithoutACellNothingIsWritten) {
  const CellByCell cells;
  EXPECT_THROW(cells.collect(), WorkError);
  EXPECT_FALSE(fs::exists(cells.folder / "results"));
}

// A scheduler does not begin what needs a job that has failed.
TEST(UnitCollect, CellsOfAFailedReferenceHaveFailedAsInOneRun) {
  const CellByCell cells;
  write_text(cells.folder / "one.json",
             R"({"format": "pellucid-scene", "version": 1, "objects": [{"mesh": "none.ply"}]})");
  cells.compute("one/truth");
  const Collection collection = cells.collect();
  ASSERT_EQ(collection.rows.size(), 3u);
  EXPECT_EQ(collection.rows[2].error, "its scene's reference failed");
  EXPECT_EQ(collection.missing.size(), 3u);  // of the other scene
}

TEST(UnitCollect, CellsOfOtherBuildsAndMachinesAreSaidToBe) {
  CellByCell cells;
  cells.options.build = "one";
  for (const char* cell : {"one/truth", "one/exact-shifted"}) cells.compute(cell);
  cells.options.build = "another";
  cells.compute("one/shifted:by=0.5");
  const fs::path file = cells.folder / "results/cells/one/exact-shifted.json";
  nlohmann::json row = read_json(file);
  row["machine"]["cpu"] = "abacus";
  write_text(file, row.dump());
  const std::vector<std::string> warnings = provenance_warnings(cells.collect().rows);
  EXPECT_THAT(warnings, Contains(HasSubstr("2 builds")));
  EXPECT_THAT(warnings, Contains(HasSubstr("abacus")));
  EXPECT_THAT(read_text(cells.folder / "results/report.html"), HasSubstr("2 builds"));
}

// Each report in a folder takes away what the one before it has left.
TEST(UnitCollect, TwoAtOnceLeaveOneWholeReport) {
  CellByCell cells;
  for (const char* cell : {"one/truth", "one/exact-shifted"}) cells.compute(cell);
  cells.options.report.kind = ReportForm::Kind::folder;
  std::vector<std::jthread> collectors;
  for (int i = 0; i < 4; ++i)
    collectors.emplace_back([&] {
      for (int times = 0; times < 5; ++times) EXPECT_NO_THROW(cells.collect());
    });
  collectors.clear();
  const fs::path results = cells.folder / "results";
  EXPECT_GT(std::distance(fs::directory_iterator(results / "report"), {}), 2);
  for (const auto& entry : fs::recursive_directory_iterator(results))
    EXPECT_NE(entry.path().filename().string()[0], '.') << entry.path();
}

}  // namespace
}  // namespace pellucid::compare::testing
