// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/changes/changes.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "compare/changes/change_texts.h"
#include "compare/changes/changes_page.h"
#include "compare/changes/number_changes.h"
#include "compare/changes/picture_changes.h"
#include "compare/pictures/image_file.h"
#include "core/error.h"
#include "tests/compare/run/studies.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using namespace pellucid::compare::testing;

/// A row of a time with an interval around it.
ResultRow timed(double seconds, double half) {
  ResultRow row;
  row.repeats = 5;
  row.steps = {{"all", {}}};
  row.seconds = {.median = seconds, .min = seconds - 2 * half, .max = seconds + 2 * half};
  row.seconds.interval = {seconds - half, seconds + half};
  return row;
}

ResultRow with_rmse(double rmse) {
  ResultRow row;
  for (std::size_t i = 0; i < metrics().size(); ++i)
    if (metrics()[i].name == "rmse") row.metrics.linear[i] = rmse;
  return row;
}

std::vector<std::string> titles(const std::vector<NumberChange>& changes) {
  std::vector<std::string> all;
  for (const NumberChange& change : changes) all.push_back(change.title);
  return all;
}

TEST(UnitNumberChanges, TimesDifferWhereTheirIntervalsPart) {
  EXPECT_THAT(number_changes(timed(1, 0.1), timed(1.15, 0.1)), IsEmpty());
  const auto changes = number_changes(timed(1, 0.1), timed(1.25, 0.1));
  ASSERT_THAT(titles(changes), ElementsAre("Time [ms]"));
  EXPECT_TRUE(changes[0].is_time);
  EXPECT_EQ(changes[0].better, false);
  EXPECT_EQ(number_changes(timed(1.25, 0.1), timed(1, 0.1))[0].better, true);
}

TEST(UnitNumberChanges, FewTimesHaveTheirExtremes) {
  ResultRow a = timed(1, 0.1), b = timed(1.25, 0.1);
  a.seconds.interval.reset();
  b.seconds.interval.reset();
  EXPECT_THAT(number_changes(a, b), IsEmpty());  // 0.8 … 1.2 and 1.05 … 1.45
  b.seconds.min = 1.21;
  EXPECT_EQ(number_changes(a, b).size(), 1u);
  a.repeats = 1;  // one time has no spread
  EXPECT_THAT(number_changes(a, b), IsEmpty());
}

/// The worst of views is a metric, which step took longest a time, and a share of an error's budget
/// as uncertain as the error is small.
TEST(UnitNumberChanges, MeasuresAreHeldToWhatTheyAre) {
  const auto with = [](const char* name, double value) {
    ResultRow row = with_rmse(0.1);
    row.measures.push_back({name, name, "", value, scene::Measure::Better::lower});
    return row;
  };
  const auto count = [&](const char* name, double a, double b) {
    return number_changes(with(name, a), with(name, b)).size();
  };
  EXPECT_EQ(count("rmse_worst", 1e-8, 2e-8), 0u);
  EXPECT_EQ(count("rmse_worst", 1e-8, 1e-5), 1u);
  EXPECT_EQ(count("flip_worst", 0.1, 0.10009), 0u);
  EXPECT_EQ(count("flicker", 0, 1e-7), 0u);
  EXPECT_EQ(count("longest_step", 2, 3), 0u);
  EXPECT_EQ(count("hull_pixels", 2, 3), 1u);
  const auto with_share = [](double share) {
    ResultRow row = with_rmse(0.1);
    BudgetLine mesh;
    mesh.stage = "mesh";
    mesh.share = share;
    row.budget = ErrorBudget{.rmse = 0.01, .lines = {mesh}};
    return row;
  };
  EXPECT_THAT(titles(number_changes(with_share(0.1), with_share(0.9))),
              ElementsAre("Share of 'mesh' in the error"));
  EXPECT_THAT(number_changes(with_share(0.1), with_share(0.10005)), IsEmpty());
}

TEST(UnitNumberChanges, MetricsDifferBeyondRounding) {
  EXPECT_THAT(number_changes(with_rmse(0.5), with_rmse(0.5 + 0.9 * rounding_of_picture)),
              IsEmpty());
  const auto changes = number_changes(with_rmse(0.5), with_rmse(0.5 + 1.1 * rounding_of_picture));
  ASSERT_THAT(titles(changes), ElementsAre("RMSE"));
  EXPECT_FALSE(changes[0].is_time);
}

TEST(UnitNumberChanges, CountsAreExactAndMeasuresRelative) {
  ResultRow a, b;
  a.fragments = 1'000'000'000'000, b.fragments = a.fragments + 1;
  EXPECT_EQ(number_changes(a, b).size(), 1u);
  b.fragments = a.fragments;
  a.measures = {{"gap", "Gap", "m", 1e6, scene::Measure::Better::lower}};
  b.measures = {{"gap", "Gap", "m", 1e6 + 0.5, scene::Measure::Better::lower}};
  EXPECT_THAT(number_changes(a, b), IsEmpty());
  b.measures[0].value = 1e6 + 2;
  EXPECT_EQ(number_changes(a, b).size(), 1u);
  b.measures.clear();
  EXPECT_EQ(number_changes(a, b).size(), 1u);
}

TEST(UnitNumberChanges, MemoryDiffersBeyondThatOfSomeThreads) {
  ResultRow a, b;
  a.bytes = {{"list", 40'000'000}};
  b.bytes = {{"list", 45'000'000}};
  EXPECT_THAT(number_changes(a, b), IsEmpty());
  b.bytes[0].bytes = 47'000'000;
  ASSERT_EQ(number_changes(a, b).size(), 1u);
  EXPECT_TRUE(number_changes(a, b)[0].is_time);
}

TEST(UnitPictureChange, TellsTheFirstPixelAndTheLargestDifference) {
  Image a(3, 2), b = a;
  EXPECT_FALSE(picture_change(a, b).has_value());
  b.at(2, 0).g = 0.25f;
  b.at(0, 1).a = -0.5f;
  const PictureChange change = picture_change(a, b).value();
  EXPECT_EQ(change.pixels, 2u);
  EXPECT_EQ(change.x, 2);
  EXPECT_EQ(change.y, 0);
  EXPECT_EQ(change.largest, 0.5);
  EXPECT_TRUE(change.beyond_rounding());
}

TEST(UnitPictureChange, BitsDecideAndNotANumberEqualsItself) {
  Image a(1, 1), b(1, 1);
  a.at(0, 0).r = 0.f, b.at(0, 0).r = -0.f;
  EXPECT_FALSE(picture_change(a, b).value().beyond_rounding());
  a.at(0, 0).r = b.at(0, 0).r = std::nanf("");
  EXPECT_FALSE(picture_change(a, b).has_value());
  b.at(0, 0).r = 1;
  EXPECT_EQ(picture_change(a, b).value().largest, std::numeric_limits<double>::infinity());
}

/// Against what is no number; null would say that nobody knows.
TEST(UnitPictureChange, AnInfiniteDifferenceIsSaidSo) {
  PictureChange change;
  change.pixels = 1;
  change.largest = std::numeric_limits<double>::infinity();
  RunChanges changes;
  changes.cells.push_back({"s/m", CellChange::Kind::changed, {}, {change}, {}});
  EXPECT_EQ(to_json(changes)["cells"][0]["pictures"][0]["largest"], "inf");
}

/// Two runs of a study of two scenes and two methods.
class UnitRunChanges : public ::testing::Test {
 protected:
  UnitRunChanges() {
    compare::testing::run(folder_, two_methods);
    fs::copy(folder_ / "results", folder_ / "after", fs::copy_options::recursive);
  }

  RunChanges changes() const {
    return compare_runs(read_past_run(folder_ / "results"), read_past_run(folder_ / "after"));
  }
  template <class Edit>
  void edit(const Edit& change) const {
    const fs::path file = folder_ / "after" / "results.json";
    nlohmann::json json = nlohmann::json::parse(read_text(file));
    change(json);
    write_text(file, json.dump());
  }
  std::string refusal() const {
    try {
      changes();
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  StudyFolder folder_;
};

TEST_F(UnitRunChanges, ARunIsItsOwnEqual) {
  const RunChanges all = changes();
  EXPECT_FALSE(all.differ(true));
  EXPECT_EQ(all.cells.size(), 6u);
  EXPECT_THAT(lines_of(all), ElementsAre("6 of 6 cells are the same"));
}

TEST_F(UnitRunChanges, APixelIsFound) {
  const fs::path file = folder_ / "after" / "images" / "two" / "shifted-by-0.5.exr";
  Image image = read_image(file);
  image.at(4, 7).b += 0.125f;
  write_image(file, image, {});
  const RunChanges all = changes();
  EXPECT_TRUE(all.differ(false));
  EXPECT_THAT(lines_of(all),
              ElementsAre("two/shifted:by=0.5: changed",
                          "  picture: 1 pixels differ, the first at (4, 7), by up to 0.125",
                          "5 of 6 cells are the same"));
  write_changes(folder_ / "page", all, read_past_run(folder_ / "results"),
                read_past_run(folder_ / "after"));
  const std::string page = read_text(folder_ / "page" / "changes.html");
  EXPECT_THAT(page, HasSubstr("<h2>two/shifted:by=0.5: changed</h2>"));
  EXPECT_THAT(page, HasSubstr("the first at (4, 7)"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "page"), {}), 2);
}

TEST_F(UnitRunChanges, APictureThatIsGoneIsSaid) {
  fs::remove(folder_ / "after" / "images" / "one" / "truth.exr");
  EXPECT_THAT(lines_of(changes())[1], HasSubstr("truth.exr is missing"));
  EXPECT_TRUE(changes().differ(false));
}

TEST_F(UnitRunChanges, TimesDoNotCountWhereTheyAreIgnored) {
  edit([](nlohmann::json& json) {
    nlohmann::json& seconds = json["rows"][1]["seconds"];
    seconds["median"] = seconds["min"] = seconds["max"] = 7;
  });
  EXPECT_TRUE(changes().differ(true));
  EXPECT_FALSE(changes().differ(false));
  EXPECT_THAT(lines_of(changes())[1], HasSubstr("Time [ms]: 750.0 → 7000.0, worse"));
}

TEST_F(UnitRunChanges, CellsComeGoAndFail) {
  edit([](nlohmann::json& json) {
    json["rows"][1]["parameters"] = "by=0.75";
    json["rows"][2]["error"] = "no memory";
  });
  EXPECT_THAT(lines_of(changes()),
              ElementsAre("one/shifted:by=0.5: missing", "one/exact-shifted: changed",
                          "  Outcome: done → no memory, worse", "one/shifted:by=0.75: new",
                          "4 of 7 cells are the same"));
}

/// A command that fails on either side is another failure, and no worse.
TEST_F(UnitRunChanges, OneErrorIsNoWorseThanAnother) {
  PastRun before = read_past_run(folder_ / "results"), after = read_past_run(folder_ / "after");
  before.rows[2].error = "no time";
  after.rows[2].error = "no memory";
  const RunChanges both = compare_runs(before, after);
  EXPECT_THAT(lines_of(both), Contains("  Outcome: no time → no memory"));
}

TEST_F(UnitRunChanges, OtherInputsAreTheCause) {
  edit([](nlohmann::json& json) {
    json["rows"][0]["fragments"] = 1;
    for (auto& file : json["rows"][0]["files_read"].items())
      if (file.key().ends_with("triangle.ply")) file.value() = "0123";
  });
  EXPECT_THAT(changes().cells[0].causes, ElementsAre("triangle.ply has other content"));
}

TEST_F(UnitRunChanges, OtherStudiesAndFilesAreRefused) {
  edit([](nlohmann::json& json) { json["study"]["name"] = "other"; });
  EXPECT_THAT(refusal(), HasSubstr("of study 'other', not of 'study'"));
  edit([](nlohmann::json& json) { json["rows"] = nlohmann::json::array(); });
  EXPECT_THAT(refusal(), HasSubstr("they have no cell in common"));
  edit([](nlohmann::json& json) { json["rows"] = {{{"scene", "one"}}}; });
  EXPECT_THAT(refusal(), HasSubstr("its row 1 is of another version"));
  edit([](nlohmann::json& json) { json["version"] = 2; });
  EXPECT_THAT(refusal(), HasSubstr("results.json: version"));
  fs::remove(folder_ / "after" / "results.json");
  EXPECT_THAT(refusal(), HasSubstr("has no results.json"));
}

}  // namespace
}  // namespace pellucid::compare
