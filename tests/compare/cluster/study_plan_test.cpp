// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cluster/study_plan.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "core/files/json_text.h"
#include "tests/compare/cluster/cells.h"

namespace pellucid::compare::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;

TEST(UnitPlan, EveryCellIsALineAfterWhatItNeeds) {
  const CellByCell cells;
  const std::vector<PlannedCell> plan = plan_study(cells.study, cells.options);
  ASSERT_EQ(plan.size(), 6u);
  EXPECT_EQ(plan[0].cell, "one/truth");
  EXPECT_TRUE(plan[0].needs.empty());
  EXPECT_EQ(plan[4].cell, "two/shifted:by=0.5");
  EXPECT_THAT(plan[4].needs, ElementsAre("two/truth"));
  const nlohmann::json line = parse_json("plan", plan_line(plan[4]));
  EXPECT_EQ(line["cell"], "two/shifted:by=0.5");
  EXPECT_EQ(line["needs"], nlohmann::json({"two/truth"}));
  EXPECT_EQ(line["scene"], "two");
  EXPECT_EQ(line["pixels"], 13 * 40);
  EXPECT_EQ(line["bytes_read"], fs::file_size(cells.folder / "two.json") +
                                    fs::file_size(cells.folder / "triangle.ply"));
  EXPECT_GT(line["seconds"], 0);
  EXPECT_GT(line["bytes"], 0);
  EXPECT_EQ(line["timed"], true);
  EXPECT_EQ(line["done"], false);
  EXPECT_FALSE(fs::exists(cells.folder / "results"));
}

/// The fakes say that a picture takes 0.75 s: the first and two that are timed.
TEST(UnitPlan, WhatIsKnownOfACellOrItsSceneIsItsEstimate) {
  CellByCell cells;
  const double least = 3 * 0.75;
  EXPECT_LT(plan_study(cells.study, cells.options)[1].estimate.seconds, least);
  cells.compute("one/truth");
  const std::vector<PlannedCell> plan = plan_study(cells.study, cells.options);
  EXPECT_TRUE(plan[0].done);
  EXPECT_FALSE(plan[1].done);
  EXPECT_NEAR(plan[0].estimate.seconds, least + 1, 0.1);  // and what the program takes to start
  EXPECT_NEAR(plan[1].estimate.seconds, least + 1, 0.1);
  EXPECT_LT(plan[4].estimate.seconds, least);  // another scene's
  cells.options.build = "another";             // by which a cell is computed again
  const PlannedCell again = plan_study(cells.study, cells.options)[0];
  EXPECT_FALSE(again.done);
  EXPECT_NEAR(again.estimate.seconds, least + 1, 0.1);
}

TEST(UnitPlan, SizesAreThoseOfTheFile) {
  const StudyFolder folder;
  write_text(folder / "path.json", R"({"format": "pellucid-scene", "version": 1, "samples": 3,
    "resolution": [30, 20], "camera_path": {"frames": 7, "orbit": 90}, "objects": []})");
  Views along_path, orbit;
  along_path.path = true;
  orbit.orbit = 5;
  const SceneSize size = scene_size(folder / "path.json", along_path);
  EXPECT_EQ(size.pixels, 600);
  EXPECT_EQ(size.samples, 9);
  EXPECT_EQ(size.views, 7);
  EXPECT_EQ(scene_size(folder / "path.json", orbit).views, 5);
  EXPECT_EQ(scene_size(folder / "path.json", {}).views, 1);
}

TEST(UnitPlan, WherePicturesAreDrawnOnceNothingIsTimed) {
  const auto timed = [](const CellByCell& cells) {
    std::vector<bool> each;
    for (const PlannedCell& cell : plan_study(cells.study, cells.options))
      each.push_back(cell.timed);
    return each;
  };
  constexpr const char* methods = R"(["shifted", {"picture": "{scene}.exr", "name": "theirs"}])";
  EXPECT_THAT(timed(CellByCell(methods)), ElementsAre(true, true, false, true, true, false));
  EXPECT_THAT(timed(CellByCell(methods, R"("repeats": 1)")),
              ElementsAre(false, false, false, false, false, false));
}

}  // namespace
}  // namespace pellucid::compare::testing
