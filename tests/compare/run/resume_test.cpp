// SPDX-License-Identifier: GPL-3.0-or-later
// Studies that go on, and parts of studies.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "tests/compare/run/studies.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using namespace pellucid::compare::testing;

TEST(UnitResume, NoFinishedCellIsComputedTwice) {
  const StudyFolder folder;
  const StudyOutcome first = run(folder, two_methods);
  const StudyOutcome second = run(folder, two_methods, true);
  EXPECT_EQ(second.computed, 0u);
  EXPECT_EQ(second.kept, 6u);
  for (std::size_t i = 0; i < first.rows.size(); ++i)
    EXPECT_EQ(to_json(first.rows[i]), to_json(second.rows[i]));
  EXPECT_EQ(run(folder, two_methods, false).computed, 6u);
}

TEST(UnitResume, OnlyWhatIsNewOrChangedOrLostIsComputed) {
  const StudyFolder folder;
  run(folder, two_methods);
  EXPECT_EQ(run(folder, R"(["shifted:by=0.5", "shifted:by=0.75"])", true).computed, 2u);
  fs::remove(folder / "results/images/one/shifted-by-0.5.exr");
  EXPECT_EQ(run(folder, two_methods, true).computed, 1u);
  run(folder, R"(["measuring"])");
  fs::remove(folder / "results/images/one/measuring.depth.png");
  EXPECT_EQ(run(folder, R"(["measuring"])", true).computed, 1u);
  run(folder, two_methods);
  write_text(folder / "results/cells/two/truth.json", "{\"scene\":");
  EXPECT_EQ(run(folder, two_methods, true).computed, 1u);
  write_scene(folder / "one.json", 24, 17);
  EXPECT_EQ(run(folder, two_methods, true).computed, 3u);
  write_text(folder / "triangle.ply", read_text(folder / "triangle.ply") + "\n");
  EXPECT_EQ(run(folder, two_methods, true).computed, 6u);  // both scenes draw it
}

TEST(UnitResume, AnotherReferenceOrDriverMakesOtherCells) {
  const StudyFolder folder;
  run(folder, R"(["shifted"])");
  std::string text = read_text(folder / "study.json");
  text.replace(text.find("truth"), 5, "exact-shifted");
  write_text(folder / "study.json", text);
  const Study study = load_study(folder / "study.json", fake_methods());
  StudyOptions options;
  options.folder = folder / "results";
  options.resume = true;
  const StudyOutcome outcome = run_study(study, options);
  EXPECT_EQ(outcome.computed, 4u);
  EXPECT_DOUBLE_EQ(*row_of(outcome, "one", "shifted").metrics.linear.of("rmse"), 0.125);
  options.context.gl = "egl";
  EXPECT_EQ(run_study(study, options).computed, 4u);
}

/// The other scene's picture has another error, though a row's own scene and its files are the
/// same.
TEST(UnitResume, AnotherReferenceSceneMakesOtherCells) {
  const StudyFolder folder;
  write_text(folder / "copy.json", read_text(folder / "one.json"));
  const auto run_against = [&](const std::string& scene) {
    const std::string key = fmt::format(R"("reference_scene": {{"one": "{}"}})", scene);
    StudyOptions options;
    options.folder = folder / "results";
    options.resume = true;
    return run_study(load_study(folder.study(R"(["shifted"])", key), fake_methods()), options);
  };
  EXPECT_EQ(run_against("one.json").computed, 4u);
  EXPECT_EQ(run_against("one.json").computed, 0u);
  write_scene(folder / "copy.json", 24, 17);
  EXPECT_EQ(run_against("copy.json").computed, 2u);
}

TEST(UnitResume, AnotherBuildsRowsAreComputedAgain) {
  const StudyFolder folder;
  const Study study = load_study(folder.study(two_methods), fake_methods());
  StudyOptions options;
  options.folder = folder / "results";
  options.build = "one";
  options.calibrate = [] { return Calibration{1, 1}; };  // a machine that nothing disturbs
  run_study(study, options);
  options.resume = true;
  EXPECT_EQ(run_study(study, options).computed, 0u);
  options.build = "another";
  options.only = {"shifted*"};
  EXPECT_EQ(run_study(study, options).computed, 2u);  // those left out stay the first build's,
  const auto mixed = nlohmann::json::parse(read_text(folder / "results/results.json"));
  EXPECT_EQ(mixed["warnings"].size(), 1u);  // and the report says so
  EXPECT_THAT(read_text(folder / "results/table.md"), HasSubstr("2 builds"));
  EXPECT_THAT(read_text(folder / "results/report.html"), HasSubstr("2 builds"));
  options.only.clear();
  EXPECT_EQ(run_study(study, options).computed, 4u);
  const auto whole = nlohmann::json::parse(read_text(folder / "results/results.json"));
  EXPECT_EQ(whole["warnings"].size(), 0u);
}

TEST(UnitResume, ANumberOfRepeatsIsPartOfARow) {
  const StudyFolder folder;
  StudyOptions options;
  options.folder = folder / "results";
  run_study(load_study(folder.study(two_methods), fake_methods()), options);
  options.resume = true;
  const auto more = folder.study(two_methods, R"("repeats": 3)");
  EXPECT_EQ(run_study(load_study(more, fake_methods()), options).computed, 6u);
}

/// 2 × 2 × 2 samples of one velocity, raw beside their header.
void write_meta_image(const fs::path& header, const std::string& raw, float velocity) {
  write_text(header,
             "NDims = 3\nDimSize = 2 2 2\nElementType = MET_FLOAT\n"
             "ElementNumberOfChannels = 3\nElementDataFile = " +
                 raw + "\n");
  const std::vector<float> samples(3 * 8, velocity);
  write_text(header.parent_path() / raw,
             {reinterpret_cast<const char*>(samples.data()), samples.size() * sizeof(float)});
}

TEST(UnitResume, FilesBehindFilesAreHashedByTheirContent) {
  const StudyFolder folder;
  write_meta_image(folder / "a.mhd", "a.raw", 0.1f);
  write_meta_image(folder / "b.mhd", "b.raw", 0.1f);
  write_text(folder / "both.series", R"({"file-series-version": "1.0", "files": [
    {"name": "a.mhd", "time": 0}, {"name": "b.mhd", "time": 1}]})");
  write_text(folder / "two.json", R"({"format": "pellucid-scene", "version": 1,
    "resolution": [24, 16], "camera": {"eye": [0.5, 0.5, 5], "target": [0.5, 0.5, 0]},
    "objects": [{"surface": {"field": "both.series", "integrator": "fixed-front:particles=3",
      "seed": {"from": [0.1, 0.2, 0.3], "to": [0.1, 0.8, 0.3]}, "duration": 1}}]})");
  for (const ResultRow& row : run(folder, R"(["shifted"])").rows) ASSERT_EQ(row.error, "");
  EXPECT_EQ(run(folder, R"(["shifted"])", true).computed, 0u);
  write_meta_image(folder / "b.mhd", "b.raw", 0.1f);  // a new file of the old content
  EXPECT_EQ(run(folder, R"(["shifted"])", true).computed, 0u);
  write_meta_image(folder / "b.mhd", "b.raw", 0.2f);
  EXPECT_EQ(run(folder, R"(["shifted"])", true).computed, 2u);
}

/// A folder of results may move, and be packed: what a study has written is none of its inputs.
TEST(UnitResume, ItsOwnPicturesAreNoInputs) {
  const StudyFolder folder;
  for (const ResultRow& row : run(folder, R"(["shifted"])", false).rows) {
    EXPECT_FALSE(row.files_read.empty());
    for (const auto& [file, hash] : row.files_read) {
      EXPECT_EQ(file.find("/images/"), file.npos) << file;
      EXPECT_EQ(file.find("pellucid-read-picture"), file.npos) << file;
    }
  }
}

TEST(UnitResume, AFailedCellIsTriedAgain) {
  const StudyFolder folder;
  run(folder, R"(["broken"])");
  EXPECT_EQ(run(folder, R"(["broken"])", true).computed, 2u);
}

TEST(UnitOnly, ShareTheWorkByPatternsInAnyOrder) {
  const StudyFolder whole, parts;
  const StudyOutcome expected = run(whole, two_methods);
  EXPECT_EQ(run(parts, two_methods, false, "two/exact*").computed, 2u);  // and its reference
  EXPECT_EQ(run(parts, two_methods, false, "shifted*").computed, 3u);    // and the other reference
  EXPECT_EQ(run(parts, two_methods, false, "one").rows.size(), 6u);
  const StudyOutcome collected = run(parts, two_methods, true);
  EXPECT_EQ(collected.computed, 0u);
  ASSERT_EQ(collected.rows.size(), expected.rows.size());
  for (std::size_t i = 0; i < expected.rows.size(); ++i) {
    nlohmann::json a = without_times(collected.rows[i]), b = without_times(expected.rows[i]);
    a.erase("scene_provenance"), b.erase("scene_provenance");  // holds the folder's name
    a.erase("fingerprint"), b.erase("fingerprint");
    a.erase("files_read"), b.erase("files_read");  // their paths
    EXPECT_EQ(a, b);
  }
}

TEST(UnitOnly, APatternThatFitsNothingIsNamed) {
  const StudyFolder folder;
  try {
    run(folder, two_methods, false, "three/*");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("'three/*': fits no cell"));
  }
}

/// The study is killed at its n-th rendering, in a process of its own, and resumed.
class SlowKilledStudy : public ::testing::TestWithParam<int> {};

TEST_P(SlowKilledStudy, IsCompletedToTheSameNumbers) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const StudyFolder whole;
  const StudyOutcome expected = run(whole, two_methods);
  // The child is a new process that comes here again: it learns the folder from its environment.
  const StudyFolder own;
  ::setenv("PELLUCID_KILLED_STUDY", own.path().c_str(), 0);
  const fs::path folder = ::getenv("PELLUCID_KILLED_STUDY");
  const auto run_in = [&](bool resume) {
    const Study study = load_study(folder / "study.json", fake_methods());
    StudyOptions options;
    options.folder = folder / "results";
    options.resume = resume;
    return run_study(study, options);
  };
  own.study(two_methods);
  EXPECT_EXIT(
      {
        RenderCounter::renders = 0;
        RenderCounter::kill_at = GetParam();
        run_in(false);
      },
      ::testing::KilledBySignal(SIGKILL), "");
  const StudyOutcome resumed = run_in(true);
  ::unsetenv("PELLUCID_KILLED_STUDY");
  EXPECT_EQ(resumed.kept, std::size_t(GetParam() - 1) / 3);  // renderings per cell
  ASSERT_EQ(resumed.rows.size(), expected.rows.size());
  for (std::size_t i = 0; i < expected.rows.size(); ++i) {
    EXPECT_EQ(resumed.rows[i].metrics.linear.of("rmse"),
              expected.rows[i].metrics.linear.of("rmse"));
    EXPECT_EQ(resumed.rows[i].metrics.linear.of("ssim"),
              expected.rows[i].metrics.linear.of("ssim"));
    EXPECT_EQ(resumed.rows[i].fragments, expected.rows[i].fragments);
  }
  EXPECT_EQ(resumed.computed + resumed.kept, 6u);
}

INSTANTIATE_TEST_SUITE_P(AtRendering, SlowKilledStudy, ::testing::Values(1, 2, 3, 4, 9, 18));

/// A file that a call names is found from the study on; the call's name is the same from anywhere.
TEST(UnitResume, ACallWithAFileIsTheSameFromAnotherFolder) {
  const StudyFolder folder;
  const fs::path study = folder.study(R"(["filed:file=own/it.json"])");
  const fs::path here = fs::current_path();
  const auto run_from = [&](const fs::path& place, bool resume) {
    fs::current_path(place);
    const Study loaded = load_study(fs::relative(study), fake_methods());
    EXPECT_EQ(loaded.methods[0].text(), "filed:file=own/it.json");
    EXPECT_EQ(fs::weakly_canonical(fs::absolute(loaded.methods[0].parameters.text("file"))),
              fs::weakly_canonical(folder / "own/it.json"));
    StudyOptions options;
    options.folder = folder / "results";
    options.resume = resume;
    return run_study(loaded, options);
  };
  fs::create_directory(folder / "own");
  run_from(folder.path(), false);
  const StudyOutcome again = run_from(folder / "own", true);
  fs::current_path(here);
  EXPECT_EQ(again.computed, 0u);
}

}  // namespace
}  // namespace pellucid::compare
