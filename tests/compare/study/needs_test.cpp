// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes whose data do not come with the study.
#include "compare/study/needs.h"

#include <gmock/gmock.h>

#include "compare/study/study.h"
#include "core/error.h"
#include "tests/compare/fake_methods.h"
#include "tests/compare/study_error.h"
#include "tests/compare/study_folder.h"

namespace pellucid::compare {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using namespace pellucid::compare::testing;

constexpr const char* needs = R"("needs": {"two": ["one.json", "wind.vtu"]})";

std::string needs_error(const std::string& more) { return study_error(R"(["shifted"])", more); }

TEST(UnitNeeds, ASceneIsLeftOutUntilItsDataAreThere) {
  const StudyFolder folder;
  const auto file = folder.study(R"(["shifted"])", needs);
  const Study without = load_study(file, fake_methods());
  EXPECT_THAT(without.scenes, ElementsAre(folder / "one.json"));
  const std::string said = "'two' is left out: " + (folder / "wind.vtu").string();
  EXPECT_THAT(without.notes, ElementsAre(HasSubstr(said)));
  ASSERT_EQ(without.left_out.size(), 1u);
  EXPECT_THAT(without.left_out.front().text(), HasSubstr(said));

  write_text(folder / "wind.vtu", "here");
  const Study with = load_study(file, fake_methods());
  EXPECT_THAT(with.scenes, ElementsAre(folder / "one.json", folder / "two.json"));
  EXPECT_THAT(with.notes, IsEmpty());
  EXPECT_THAT(with.left_out, IsEmpty());
}

TEST(UnitNeeds, WhatOtherKeysSayOfTheSceneStaysRight) {
  const StudyFolder folder;
  const auto file =
      folder.study(R"(["shifted"])", std::string(needs) + R"(, "crops": {"two": [0, 0, 2, 2]})");
  EXPECT_THAT(load_study(file, fake_methods()).scenes, ElementsAre(folder / "one.json"));
}

TEST(UnitNeeds, OtherScenesAndTypesAreRefused) {
  EXPECT_THAT(needs_error(R"("needs": {"tow": "x.vtu"})"),
              AllOf(HasSubstr("needs: unknown scene 'tow'"), HasSubstr("two")));
  EXPECT_THAT(needs_error(R"("needs": {"two": 3})"), HasSubstr("needs.two"));
  EXPECT_THAT(needs_error(R"("needs": {"one": "x.vtu", "two": "y.vtu"})"),
              AllOf(HasSubstr("x.vtu is missing"), HasSubstr("one scene at least")));
}

}  // namespace
}  // namespace pellucid::compare
