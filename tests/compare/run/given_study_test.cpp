// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures from elsewhere are cells of a study: drawn by a command, or there already.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "compare/methods/given_method.h"
#include "compare/pictures/image_file.h"
#include "compare/report/tables.h"
#include "compare/results/columns.h"
#include "compare/results/provenance.h"
#include "compare/run/tune.h"
#include "core/error.h"
#include "tests/compare/run/studies.h"

namespace pellucid::compare::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

/// Both scenes' pictures lie in the folder; scripts copy them.
class UnitGivenStudy : public ::testing::Test {
 protected:
  void SetUp() override {
    write_picture("one", 24, 16);
    write_picture("two", 13, 40);
  }

  /// What the fake reference draws, darker by `by`.
  void write_picture(const std::string& scene, int width, int height, float by = 0.125f) const {
    Image image(width, height);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) image.at(x, y) = Rgba(float(x * y % 64) / 128.f - by);
    write_image(folder_ / (scene + ".exr"), image, {});
  }

  /// Why a study of these methods is refused.
  std::string refusal(const std::string& methods) const {
    try {
      load_study(folder_.study(methods), fake_methods());
      return "";
    } catch (const InputError& error) {
      return error.what();
    }
  }

  /// A command of this script. $1 is the scene, $2 the camera, $3 the output.
  std::string command(const std::string& script, const std::string& more = "") const {
    write_text(folder_ / "mine.sh", script + "\n");
    return R"([{"external": "mine", "command": ["sh", "mine.sh", "{scene}", "{camera}", "{output}"])" +
           more + "}]";
  }
  /// The scenes' pictures differ in size: the height tells which one is asked for.
  std::string copies() const {
    const std::string in = folder_.path().string();
    return "if grep -q '^  24' $1 || grep -q '\"name\": \"one\"' $1; then cp " + in +
           "/one.exr $3; else cp " + in + "/two.exr $3; fi";
  }

  std::string value(const ResultRow& row, std::string_view column) const {
    for (const Column& c : columns())
      if (c.name == column) return c.value(row) ? fmt::format("{}", *c.value(row)) : "";
    return "no such column";
  }

  StudyFolder folder_;
};

/// Each cell has files of its own, whatever its name.
TEST_F(UnitGivenStudy, NamesWhoseFilesWouldBeThoseOfAnotherCallAreRefused) {
  EXPECT_THAT(refusal(R"(["shifted:by=0.5", {"picture": "a.exr", "name": "shifted-by-0.5"}])"),
              HasSubstr("'shifted:by=0.5' and 'shifted-by-0.5' would share their files"));
  EXPECT_THAT(
      refusal(R"([{"picture": "a.exr", "name": "a=b"}, {"picture": "a.exr", "name": "a-b"}])"),
      HasSubstr("another name"));
  EXPECT_EQ(
      refusal(
          R"([{"picture": "{scene}.exr", "name": "VTK 9.1"}, {"picture": "{scene}.exr", "name": "VTK"}])"),
      "");
}

TEST_F(UnitGivenStudy, MarksThatStandForNothingAreRefused) {
  EXPECT_THAT(refusal(R"([{"picture": "{scene}-{veiw}.exr", "name": "theirs"}])"),
              HasSubstr("nothing is known as {veiw}; accepted: {scene}, {view}"));
}

TEST(UnitSlug, IsNeverAnotherCallsEnding) {
  EXPECT_EQ(slug_of("fourier:bands=5,clamp=0.5"), "fourier-bands-5-clamp-0.5");
  for (const char* name : {"truth.layers", "truth.view-2", "..", ".", "a."})
    EXPECT_NE(slug_of(name), name);
  EXPECT_LT(slug_of(std::string(300, 'a')).size(), 120u);
  EXPECT_NE(slug_of(std::string(300, 'a')), slug_of(std::string(301, 'a')));
}

/// A row is of the pictures of all its views, and of their costs: none is not the same as 0.
TEST_F(UnitGivenStudy, AnotherPictureOfAnyViewOrAnotherCostMakesAnotherCell) {
  for (const char* view : {"-1", "-2"}) {
    write_picture(std::string("one") + view, 24, 16);
    write_picture(std::string("two") + view, 13, 40);
  }
  const auto computed = [&](const std::string& more) {
    const std::string methods = R"([{"picture": "{scene}-{view}.exr", "name": "theirs")" + more;
    const Study study =
        load_study(folder_.study(methods + "}]", R"("repeats": 1, "views": 2)"), fake_methods());
    StudyOptions options;
    options.folder = folder_ / "results";
    options.resume = true;
    return run_study(study, options).computed;
  };
  EXPECT_EQ(computed(""), 4u);
  EXPECT_EQ(computed(""), 0u);
  write_picture("one-2", 24, 16, 0.25f);
  EXPECT_EQ(computed(""), 1u);
  EXPECT_EQ(computed(R"(, "bytes": 0)"), 2u);
}

TEST_F(UnitGivenStudy, ACommandDrawsTheExportedSceneInAFolderOfItsOwn) {
  const StudyOutcome outcome =
      run(folder_, command(copies() + "; test -f $2 && echo $PWD && echo said >&2"));
  for (const char* scene : {"one", "two"}) {
    const ResultRow& row = row_of(outcome, scene, "mine");
    EXPECT_EQ(row.error, "");
    EXPECT_NEAR(*row.metrics.linear.of("rmse"), 0.125, 1e-7);
    const fs::path own = folder_ / "results" / "given" / scene / "mine";
    EXPECT_EQ(read_text(own / "stdout.txt"), own.string() + "\n");
    EXPECT_EQ(read_text(own / "stderr.txt"), "said\n");
    EXPECT_FALSE(fs::exists(own / "scene"));
    EXPECT_EQ(row.given, "command");
    EXPECT_EQ(row.repeats, 1);
    EXPECT_EQ(row.machine.at("time"), "wall clock of the command");
    EXPECT_GT(row.seconds.median, 0);
    for (const char* unknown : {"bytes", "fragments", "max_layers", "stored", "setup_seconds"})
      EXPECT_EQ(value(row, unknown), "") << unknown;
  }
  const Study study = load_study(folder_ / "study.json", fake_methods());
  EXPECT_THAT(markdown_table(study, outcome.rows), HasSubstr("| mine (given) |"));
  EXPECT_THAT(latex_table(study, outcome.rows), HasSubstr("mine (given) &"));
  EXPECT_THAT(read_text(folder_ / "results" / "report.html"), HasSubstr("mine (given: command)"));
}

TEST_F(UnitGivenStudy, ItsCostsAreThoseThatItTells) {
  const std::string costs =
      R"(; echo '{"ms": 12.5, "bytes": 4096, "steps": {"build": 2, "draw": 10}, "fragments": 77}' > $3.json)";
  const ResultRow row = row_of(run(folder_, command(copies() + costs)), "one", "mine");
  EXPECT_EQ(row.error, "");
  EXPECT_DOUBLE_EQ(row.seconds.median, 0.0125);
  EXPECT_THAT(row.steps,
              ElementsAre(::testing::Field(&std::pair<std::string, Spread>::first, "build"),
                          ::testing::Field(&std::pair<std::string, Spread>::first, "draw"),
                          ::testing::Field(&std::pair<std::string, Spread>::first, "other")));
  EXPECT_EQ(value(row, "bytes"), "4096");
  EXPECT_EQ(value(row, "fragments"), "77");
  EXPECT_EQ(row.machine.at("time"), "as the command says");
}

TEST_F(UnitGivenStudy, ItsStepsAreAnObject) {
  const std::string costs = R"(; echo '{"ms": 12.5, "steps": [2, 10]}' > $3.json)";
  EXPECT_THAT(row_of(run(folder_, command(copies() + costs)), "one", "mine").error,
              HasSubstr("steps: [2,10]; accepted: an object"));
}

TEST_F(UnitGivenStudy, WhatGoesWrongIsTheRowsErrorAndTheStudyGoesOn) {
  const auto error_of = [&](const std::string& script, const std::string& more = "") {
    std::string methods = command(script, more);
    methods.insert(methods.size() - 1, R"(, "shifted")");
    const StudyOutcome outcome = run(folder_, methods);
    EXPECT_EQ(row_of(outcome, "two", "shifted").error, "");
    return row_of(outcome, "one", "mine").error;
  };
  EXPECT_THAT(error_of("echo reading; echo no licence >&2; exit 3"),
              HasSubstr("the command ended with code 3: no licence"));
  EXPECT_THAT(error_of("kill -9 $$"), HasSubstr("ended by a signal: Killed"));
  EXPECT_THAT(error_of("sleep 20", R"(, "timeout": 0.05)"), HasSubstr("was ended after"));
  EXPECT_THAT(error_of("true"), HasSubstr("left no picture"));
  EXPECT_THAT(error_of("echo no picture > $3"), HasSubstr("output.exr"));
  EXPECT_THAT(error_of("cp " + (folder_ / "two.exr").string() + " $3"),
              HasSubstr("13 × 40 pixels; accepted: the scene's 24 × 16"));
  EXPECT_THAT(error_of(copies() + R"(; echo '{"msec": 1}' > $3.json)"), HasSubstr("msec"));
  EXPECT_THAT(error_of(copies() + R"(; echo '{"ms": 1, "steps": {"a": 3}}' > $3.json)"),
              HasSubstr("3 ms together"));
  write_picture("one", 24, 16, std::nanf(""));
  EXPECT_THAT(error_of(copies()), HasSubstr("not finite"));
}

/// A cell is the same only if the program, its files and its words are.
TEST_F(UnitGivenStudy, AChangedScriptIsAnotherCell) {
  run(folder_, command(copies()));
  EXPECT_EQ(run(folder_, command(copies()), true).computed, 0u);
  EXPECT_EQ(run(folder_, command(copies() + "\n# faster"), true).computed, 2u);
  EXPECT_EQ(run(folder_, command(copies() + "\n# faster", R"(, "timeout": 7)"), true).computed, 2u);
}

TEST_F(UnitGivenStudy, APictureIsARowOfItsScene) {
  const std::string entry = R"([{"picture": "{scene}.exr", "name": "theirs", "ms": 3.5, "bytes": 9},
                               {"picture": "{scene}.exr", "name": "unknown"}, "shifted"])";
  const StudyOutcome outcome = run(folder_, entry);
  const ResultRow& row = row_of(outcome, "two", "theirs");
  EXPECT_EQ(row.error, "");
  EXPECT_NEAR(*row.metrics.linear.of("rmse"), 0.125, 1e-7);
  EXPECT_EQ(value(row, "seconds"), "0.0035");
  EXPECT_EQ(value(row, "bytes"), "9");
  EXPECT_EQ(value(row_of(outcome, "two", "unknown"), "seconds"), "");
  EXPECT_EQ(run(folder_, entry, true).computed, 0u);
  write_picture("two", 13, 40, 0.25f);
  EXPECT_EQ(run(folder_, entry, true).computed, 2u);  // not "shifted"
  fs::remove(folder_ / "two.exr");
  EXPECT_THAT(row_of(run(folder_, entry), "two", "theirs").error, HasSubstr("two.exr"));
}

TEST_F(UnitGivenStudy, WhatLooksWrongIsSaidInTheTablesAndKept) {
  Image image = read_image(folder_ / "one.exr");
  std::reverse(image.pixels.begin(), image.pixels.end());
  for (Rgba& p : image.pixels) p += 0.125f;
  write_image(folder_ / "one.exr", image, {});
  const std::string entry = R"([{"picture": "{scene}.exr", "name": "theirs"}])";
  for (const bool resume : {false, true}) {
    const StudyOutcome outcome = run(folder_, entry, resume);
    EXPECT_THAT(row_of(outcome, "one", "theirs").given_faults, Contains(HasSubstr("180 degrees")));
    EXPECT_THAT(row_of(outcome, "one", "theirs").given_faults,
                Not(Contains(HasSubstr("stands for several"))));
    EXPECT_THAT(provenance_warnings(outcome.rows), Contains(HasSubstr("one/theirs: the picture")));
  }
}

TEST_F(UnitGivenStudy, OnePictureForAllScenesIsSaidToBeOne) {
  write_scene(folder_ / "two.json", 24, 16);
  const StudyOutcome outcome = run(folder_, R"([{"picture": "one.exr", "name": "theirs"}])");
  for (const char* scene : {"one", "two"})
    EXPECT_THAT(row_of(outcome, scene, "theirs").given_faults,
                Contains(HasSubstr("stands for several scenes: its name has no {scene}")));
}

/// Words come as they are given, and what stands for a mark is not searched for marks.
TEST_F(UnitGivenStudy, AWordMayBeEmptyAndAFolderMayHaveBraces) {
  write_text(folder_ / "mine.sh",
             "test -z \"$1\" && cp " + (folder_ / "one.exr").string() + " $2\n");
  StudyOptions options;
  options.folder = folder_ / "results-{view}-{output}";
  const Study study = load_study(
      folder_.study(R"([{"external": "mine", "command": ["sh", "mine.sh", "", "{output}"]}])"),
      fake_methods());
  EXPECT_EQ(row_of(run_study(study, options), "one", "mine").error, "");
}

/// What it does not tell is no bargain.
TEST_F(UnitGivenStudy, ACommandIsACandidateOfTune) {
  const auto cheapest = [&](const std::string& script, double rmse, Cost cost,
                            std::optional<std::uint64_t> bytes = std::nullopt) -> std::string {
    write_text(folder_ / "mine.sh", script + "\n");
    const scene::MethodRow &truth = fake_methods()[0], &shifted = fake_methods()[1];
    TuneRequest request{
        .scene = folder_ / "one.json",
        .reference = {&truth, Parameters(truth.name, {}, {})},
        .candidates = {{&shifted, Parameters(shifted.name, shifted.parameters, {})}},
        .bound = {rmse, std::nullopt, bytes},
        .cost = cost,
        .context = {},
        .progress = {},
        .on_row = {}};
    request.candidates.push_back(
        external_call({.name = "mine",
                       .words = {"sh", "mine.sh", "{scene}", "{camera}", "{output}"},
                       .base = folder_.path()}));
    const TuneOutcome outcome = tune(request);
    return outcome.best() ? outcome.best()->method : "none";
  };
  const std::string cheap = R"(; echo '{"ms": 1, "bytes": 10}' > $3.json)";
  EXPECT_EQ(cheapest(copies() + cheap, 0.2, Cost::seconds), "mine");
  EXPECT_EQ(cheapest(copies() + cheap, 0.3, Cost::bytes), "mine");
  EXPECT_EQ(cheapest(copies(), 0.3, Cost::bytes), "shifted");
  EXPECT_EQ(cheapest(copies(), 0.2, Cost::seconds, 1 << 20), "none");
}

TEST_F(UnitGivenStudy, WrongEntriesAreRefused) {
  const auto refusal = [&](const std::string& entry) {
    try {
      load_study(folder_.study("[" + entry + "]"), fake_methods());
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_THAT(refusal(R"({"external": "a", "command": ["x"]})"), HasSubstr("{output}"));
  EXPECT_THAT(refusal(R"({"external": "a", "command": []})"), HasSubstr("{output}"));
  EXPECT_THAT(refusal(R"({"external": "truth", "command": ["{output}"]})"),
              HasSubstr("another name"));
  EXPECT_THAT(refusal(R"({"external": "a:b", "command": ["{output}"]})"), HasSubstr("without ':'"));
  EXPECT_THAT(refusal(R"({"external": "a", "command": ["{output}"], "time": 1})"),
              HasSubstr("time"));
  EXPECT_THAT(refusal(R"({"external": "a", "command": ["{output}"], "timeout": 0})"),
              HasSubstr("timeout"));
  EXPECT_THAT(refusal(R"({"picture": "a.exr"})"), HasSubstr("name"));
  EXPECT_THAT(refusal(R"({"picture": "a.exr", "name": "a"}, {"picture": "b.exr", "name": "a"})"),
              HasSubstr("a second 'a'"));
}

}  // namespace
}  // namespace pellucid::compare::testing
