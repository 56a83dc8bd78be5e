// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cluster/compute_cell.h"

#include <gmock/gmock.h>

#include <set>

#include "tests/compare/cluster/cells.h"

namespace pellucid::compare::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

std::set<std::string> files_below(const fs::path& folder) {
  std::set<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files.insert(fs::relative(entry.path(), folder).string());
  return files;
}

TEST(UnitComputeCell, ItLeavesItsOwnFilesAlone) {
  const CellByCell cells;
  EXPECT_EQ(cells.compute("one/truth").error, "");
  EXPECT_THAT(files_below(cells.folder / "results"),
              ElementsAre("cells/one/truth.json", "images/one/truth.exr",
                          "images/one/truth.layers.exr", "images/one/truth.png"));
  const fs::file_time_type before =
      fs::last_write_time(cells.folder / "results/images/one/truth.exr");
  EXPECT_DOUBLE_EQ(*cells.compute("one/shifted:by=0.5").metrics.linear.of("rmse"), 0.5);
  EXPECT_EQ(files_below(cells.folder / "results").size(), 10u);
  EXPECT_EQ(fs::last_write_time(cells.folder / "results/images/one/truth.exr"), before);
}

TEST(UnitComputeCell, AnUnknownNameIsAnsweredWithTheNearest) {
  const CellByCell cells;
  EXPECT_THAT(cells.refusal("one/shifted:by=0.6"),
              StartsWith("--cell: unknown cell 'one/shifted:by=0.6'; known: one/shifted:by=0.5, "));
  EXPECT_FALSE(fs::exists(cells.folder / "results"));
}

TEST(UnitComputeCell, WithoutWhatItNeedsItSaysWhat) {
  const CellByCell cells;
  EXPECT_THAT(cells.refusal("two/exact-shifted"),
              AllOf(StartsWith("two/exact-shifted needs two/truth, which is not in "),
                    HasSubstr("--cell 'two/truth'")));
  EXPECT_THROW(cells.compute("two/exact-shifted"), WorkError);
  EXPECT_FALSE(fs::exists(cells.folder / "results"));
}

TEST(UnitComputeCell, WhatItNeedsMayBeThereAndNoUse) {
  const CellByCell cells;
  cells.compute("two/truth");
  write_scene(cells.folder / "two.json", 13, 41);
  const std::string folder = (cells.folder / "results").string();
  EXPECT_THAT(cells.refusal("two/exact-shifted"),
              HasSubstr("needs two/truth, which is in " + folder + ", but of other inputs; "));
}

TEST(UnitComputeCell, WhereItsReferenceHasFailedItDoes) {
  const CellByCell cells;
  write_text(cells.folder / "two.json",
             R"({"format": "pellucid-scene", "version": 1, "objects": [{"mesh": "none.ply"}]})");
  EXPECT_THAT(cells.compute("two/truth").error, HasSubstr("none.ply"));
  EXPECT_EQ(cells.compute("two/exact-shifted").error, "its scene's reference failed");
}

TEST(UnitComputeCell, ItIsComputedAgainUnlessItResumes) {
  CellByCell cells;
  cells.compute("one/truth");
  RenderCounter::renders = 0;
  cells.compute("one/truth");
  EXPECT_EQ(RenderCounter::renders, 3);
  cells.options.resume = true;
  EXPECT_EQ(cells.compute("one/truth").error, "");
  EXPECT_EQ(RenderCounter::renders, 3);
  cells.options.build = "another";
  cells.compute("one/truth");
  EXPECT_EQ(RenderCounter::renders, 6);
}

TEST(UnitComputeCell, WhoComparesMayGoOnWhileTheReferenceIsComputedAgain) {
  CellByCell cells;
  cells.compute("one/truth");
  int calibrations = 0;
  StudyOptions again = cells.options;
  again.calibrate = [&] {  // before and after the work
    ++calibrations;
    EXPECT_EQ(cells.compute("one/exact-shifted").error, "");
    return Calibration{1, 1};
  };
  compute_cell(cells.study, "one/truth", again);
  EXPECT_EQ(calibrations, 2);
}

/// The cell is killed at its n-th rendering, in a process of its own.
class SlowKilledCell : public ::testing::TestWithParam<int> {};

TEST_P(SlowKilledCell, LeavesNothingThatIsTakenForFinished) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const CellByCell own;
  ::setenv("PELLUCID_KILLED_CELL", own.folder.path().c_str(), 0);
  const fs::path folder = ::getenv("PELLUCID_KILLED_CELL");
  const auto compute_in = [&](const std::string& build) {
    StudyOptions options = own.options;
    options.folder = folder / "results";
    options.build = build;
    return compute_cell(load_study(folder / "study.json", fake_methods()), "one/truth", options);
  };
  if (folder == own.folder.path()) compute_in("before");  // of which a kill must not leave the row
  EXPECT_EXIT(
      {
        RenderCounter::renders = 0;
        RenderCounter::kill_at = GetParam();
        compute_in("after");
      },
      ::testing::KilledBySignal(SIGKILL), "");
  ::unsetenv("PELLUCID_KILLED_CELL");
  EXPECT_FALSE(fs::exists(own.folder / "results/cells/one/truth.json"));
  EXPECT_EQ(own.compute("one/truth").error, "");
  EXPECT_EQ(files_below(own.folder / "results").size(), 4u);
}

INSTANTIATE_TEST_SUITE_P(AtRendering, SlowKilledCell, ::testing::Values(1, 3));

}  // namespace
}  // namespace pellucid::compare::testing
