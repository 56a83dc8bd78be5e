// SPDX-License-Identifier: GPL-3.0-or-later
// Calls that are not drawn in full, since another one beats them in a smaller picture.
#include "compare/run/screening.h"

#include <gmock/gmock.h>

#include "core/error.h"
#include "tests/compare/run/studies.h"

namespace pellucid::compare {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using namespace pellucid::compare::testing;

std::vector<std::string> beaten_by(std::span<const SmallPicture> pictures, double margin) {
  std::vector<std::string> texts;
  for (const ScreenedCall& out : beaten(pictures, 0.25, margin))
    texts.push_back(out.own.call + "<" + out.by.call);
  return texts;
}

TEST(UnitScreening, OneFallsOutThatAnotherBeatsInErrorAndTimeByTheMargin) {
  const SmallPicture worse{"worse", 10, 0.1, 100}, better{"better", 4, 0.05, 100};
  const SmallPicture slower{"slower", 6, 0.05, 100}, rougher{"rougher", 4, 0.06, 100};
  const SmallPicture larger{"larger", 4, 0.05, 101};
  EXPECT_THAT(beaten_by(std::array{worse, better}, 2), ElementsAre("worse<better"));
  EXPECT_THAT(beaten_by(std::array{worse, slower}, 2), IsEmpty());
  EXPECT_THAT(beaten_by(std::array{worse, rougher}, 2), IsEmpty());
  EXPECT_THAT(beaten_by(std::array{worse, larger}, 2), IsEmpty());
  EXPECT_THAT(beaten_by(std::array{worse, slower}, 1), ElementsAre("worse<slower"));
}

TEST(UnitScreening, OfExactOnesTheSlowerFallsOut) {
  const SmallPicture slow{"slow", 10, 0, 100}, quick{"quick", 4, 0, 100};
  EXPECT_THAT(beaten_by(std::array{slow, quick}, 2), ElementsAre("slow<quick"));
  EXPECT_THAT(beaten_by(std::array{quick, quick}, 1), IsEmpty());
}

TEST(UnitScreening, WhoBeatsIsNotBeatenItself) {
  const SmallPicture a{"a", 40, 0.4, 100}, b{"b", 16, 0.1, 100}, c{"c", 7, 0.05, 100};
  EXPECT_THAT(beaten_by(std::array{a, b, c}, 2), ElementsAre("a<c", "b<c"));
}

/// The study goes on with what its rows say, and with its other scenes.
TEST(UnitScreening, AReferenceThatFailsIsAnErrorOfItsRows) {
  for (const std::string reference : {"broken", "not-a-number"}) {
    const StudyFolder folder;
    const auto file = folder.study(R"(["shifted"])", R"("repeats": 1, "screen": true)");
    std::string text = read_text(file);
    text.replace(text.find("\"truth\""), 7, '"' + reference + '"');
    write_text(file, text);
    StudyOptions options;
    options.folder = folder / "results";
    const StudyOutcome outcome = run_study(load_study(file, fake_methods()), options);
    ASSERT_EQ(outcome.rows.size(), 4u);
    EXPECT_THAT(row_of(outcome, "two", reference).error,
                HasSubstr(reference == "broken" ? "the driver lacks" : "not finite"));
    EXPECT_TRUE(std::filesystem::exists(folder / "results/table.md"));
  }
}

constexpr const char* calls = R"(["shifted:by=0.5,times=9", "shifted:by=0.25", "broken"])";

StudyOutcome run_screened(const StudyFolder& folder, bool resume = false,
                          const std::string& only = "", const std::string& screen = "true") {
  const Study study =
      load_study(folder.study(calls, "\"repeats\": 2, \"screen\": " + screen), fake_methods());
  StudyOptions options;
  options.folder = folder / "results";
  options.resume = resume;
  if (!only.empty()) options.only = {only};
  return run_study(study, options);
}

TEST(UnitScreening, WhatFallsOutHasNoRowAndIsTold) {
  const StudyFolder folder;
  const StudyOutcome outcome = run_screened(folder);
  EXPECT_EQ(outcome.rows.size(), 2u * 3);
  for (const ResultRow& row : outcome.rows) EXPECT_NE(row.parameters, "by=0.5,times=9");
  const std::string csv = read_text(folder / "results/screened.csv");
  EXPECT_THAT(csv, HasSubstr("\none,0.25,\"shifted:by=0.5,times=9\",6.75,0.5,1024,shifted"));
  EXPECT_THAT(csv, HasSubstr("\ntwo,"));
  EXPECT_THAT(read_text(folder / "results/table.md"),
              AllOf(HasSubstr("Not drawn in full"), HasSubstr("1 call of one, 1 call of two")));
}

TEST(UnitScreening, NothingFallsOutWithinTheMarginOrWithoutARule) {
  const StudyFolder folder;
  EXPECT_EQ(run_screened(folder, false, "", R"({"margin": 10})").rows.size(), 2u * 4);
  EXPECT_EQ(run_screened(folder, false, "", "false").rows.size(), 2u * 4);
}

TEST(UnitScreening, WhoResumesLeavesTheSameOutAndWhoNamesACellGetsIt) {
  const StudyFolder folder;
  run_screened(folder);
  RenderCounter::renders = 0;
  EXPECT_EQ(run_screened(folder, true).kept, 2u * 2);  // `broken` is tried again
  EXPECT_EQ(RenderCounter::renders, 0);
  EXPECT_EQ(run_screened(folder, true, "one/shifted:by=0.5*").computed, 1u);
}

TEST(UnitScreening, WrongRulesAreRefused) {
  const StudyFolder folder;
  for (const char* screen :
       {R"({"sizes": []})", R"({"sizes": [1]})", R"({"margin": 0.5})", R"({"marign": 2})", "3"})
    EXPECT_THROW(run_screened(folder, false, "", screen), InputError) << screen;
}

}  // namespace
}  // namespace pellucid::compare
