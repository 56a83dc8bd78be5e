// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/command_line.h"

namespace pellucid::app {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// The results of a study of the sheet.
class UnitPack : public UnitCommandLine {
 protected:
  void SetUp() override {
    UnitCommandLine::SetUp();
    fs::create_directory(folder_ / "studies");
    write_text(folder_ / "studies" / "s.json",
               R"({"format": "pellucid-study", "version": 1, "scenes": ["../scene.json"],
                   "reference": "raytrace", "methods": ["weighted-average"], "repeats": 1})");
    ASSERT_EQ(run("study " + file("studies/s.json") + " --quiet -o " + file("results")).exit_code,
              0);
  }

  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  std::string pack(const std::string& to) const {
    return "pack " + file("results") + " -o " + file(to);
  }
  int shell(const std::string& command) const {
    return WEXITSTATUS(std::system(("cd " + folder_.path().string() + " && " + command).c_str()));
  }
};

TEST_F(UnitPack, ElsewhereItGivesTheSamePicturesToTheLastBit) {
  ASSERT_EQ(run(pack("p.tar.gz") + " --quiet").exit_code, 0);
  ASSERT_EQ(shell("mkdir away && tar xzf p.tar.gz -C away"), 0);
  fs::rename(folder_ / "sheet.ply", folder_ / "gone.ply");  // nothing is read from where it was
  EXPECT_EQ(shell("PELLUCID=" PELLUCID_PROGRAM " away/p/run.sh > said 2>&1"), 0)
      << read_text(folder_ / "said");
  for (const char* picture : {"raytrace.exr", "weighted-average.exr"})
    EXPECT_EQ(read_text(folder_ / "away/p/again/images/scene" / picture),
              read_text(folder_ / "results/images/scene" / picture));
  EXPECT_THAT(read_text(folder_ / "said"), Not(HasSubstr("picture:")));
}

TEST_F(UnitPack, ItRunsWhereItRan) {
  if (run("study " + file("studies/s.json") + " --quiet --gl egl:software -o " + file("results"))
          .exit_code != 0)
    GTEST_SKIP() << "no EGL here";
  ASSERT_EQ(run(pack("p") + " --quiet").exit_code, 0);
  EXPECT_EQ(shell("PELLUCID=" PELLUCID_PROGRAM " p/run.sh > said 2>&1"), 0)
      << read_text(folder_ / "said");
  EXPECT_THAT(read_text(folder_ / "p/again/results.json"), HasSubstr("egl:software"));
}

/// A run of some cells, of a study of which a scene's data are missing here as they are there; the
/// program by a path from where one stands.
TEST_F(UnitPack, APartOfAStudyIsRunAgainAsThatPart) {
  write_text(folder_ / "gone.json", read_text(folder_ / "scene.json"));
  write_text(folder_ / "studies" / "s.json",
             R"({"format": "pellucid-study", "version": 1,
                 "scenes": ["../scene.json", "../gone.json"], "needs": {"gone": "../none.vdb"},
                 "reference": "raytrace", "methods": ["weighted-average", "weighted-sum"],
                 "repeats": 1})");
  fs::remove_all(folder_ / "results");
  ASSERT_EQ(run("study " + file("studies/s.json") + " --quiet --only '*-sum' --only raytrace -o " +
                file("results"))
                .exit_code,
            0);
  ASSERT_EQ(run(pack("p") + " --quiet").exit_code, 0);
  fs::create_symlink(PELLUCID_PROGRAM, folder_ / "own");
  EXPECT_EQ(shell("PELLUCID=./own p/run.sh > said 2>&1"), 0) << read_text(folder_ / "said");
  EXPECT_FALSE(fs::exists(folder_ / "p/again/images/scene/weighted-average.exr"));
  write_text(folder_ / "results/images/scene/weighted-sum.exr", "");
  EXPECT_THAT(refusal(pack("q")), HasSubstr("weighted-sum.exr: is missing or empty"));
}

TEST_F(UnitPack, WhatIsChangedInThePackageIsSeen) {
  ASSERT_EQ(run(pack("p") + " --quiet").exit_code, 0);
  std::string sheet = read_text(folder_ / "p/inputs/sheet.ply");
  sheet.replace(sheet.find("0.75"), 4, "0.70");
  write_text(folder_ / "p/inputs/sheet.ply", sheet);
  EXPECT_EQ(shell("PELLUCID=" PELLUCID_PROGRAM " p/run.sh > said 2>&1"), 2);
  EXPECT_THAT(read_text(folder_ / "said"), HasSubstr("sheet.ply"));
}

TEST_F(UnitPack, TheCrateListsEveryFile) {
  const Outcome outcome = run(pack("p") + " --json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const nlohmann::json files = nlohmann::json::parse(outcome.out).at("files");
  const nlohmann::json crate =
      nlohmann::json::parse(read_text(folder_ / "p" / "ro-crate-metadata.json"));
  std::set<std::string> parts;
  for (const nlohmann::json& part : crate["@graph"][1]["hasPart"]) parts.insert(part["@id"]);
  for (const std::string file : files)
    EXPECT_TRUE(parts.contains(file) || file == "ro-crate-metadata.json") << file;
  for (const char* file : {"inputs/studies/s.json", "inputs/scene.json", "inputs/sheet.ply",
                           "results/report.html", "run.sh", "CITATION.cff", "versions.json"})
    EXPECT_TRUE(parts.contains(file)) << file;
  EXPECT_EQ(shell("cd p && sha256sum --check --quiet manifest.sha256"), 0);
}

/// A blank and a '%' are none of a URI's characters, and a line's end none of a manifest's.
TEST_F(UnitPack, NamesMayHaveAnyCharacters) {
  write_text(folder_ / "a b\n50%.json", read_text(scene()));
  write_text(folder_ / "studies" / "s.json",
             R"({"format": "pellucid-study", "version": 1, "scenes": ["../a b\n50%.json"],
                 "reference": "raytrace", "methods": ["weighted-average"], "repeats": 1})");
  fs::remove_all(folder_ / "results");
  ASSERT_EQ(run("study " + file("studies/s.json") + " --quiet -o " + file("results")).exit_code, 0);
  ASSERT_EQ(run(pack("p") + " --quiet").exit_code, 0);
  EXPECT_EQ(shell("cd p && sha256sum --check --quiet manifest.sha256"), 0);
  EXPECT_THAT(read_text(folder_ / "p/ro-crate-metadata.json"),
              HasSubstr(R"("@id": "inputs/a%20b%0A50%25.json")"));
}

/// A scene is one by what is in it, not by how its name ends.
TEST_F(UnitPack, AnAbsolutePathIsSeenInAnySceneFile) {
  write_text(folder_ / "scene.txt", R"({"format": "pellucid-scene", "version": 1,
    "resolution": [9, 9], "objects": [{"mesh": ")" +
                                        file("sheet.ply") + R"("}]})");
  write_text(folder_ / "studies" / "s.json",
             R"({"format": "pellucid-study", "version": 1, "scenes": ["../scene.txt"],
                 "reference": "raytrace", "methods": ["weighted-average"], "repeats": 1})");
  fs::remove_all(folder_ / "results");
  ASSERT_EQ(run("study " + file("studies/s.json") + " --quiet -o " + file("results")).exit_code, 0);
  EXPECT_THAT(refusal(pack("p.zip")), AllOf(HasSubstr("scene.txt: names "), HasSubstr("absolute")));
}

/// What ".." leads to behind a link is not what is written before it.
TEST_F(UnitPack, AStudyBehindALinkIsFound) {
  fs::create_directory(folder_ / "here");
  fs::create_directory(folder_ / "studies/sub");
  fs::create_directory_symlink(folder_ / "studies/sub", folder_ / "here/sub");
  fs::remove_all(folder_ / "results");
  ASSERT_EQ(run("study " + file("here/sub/../s.json") + " --quiet -o " + file("results")).exit_code,
            0);
  EXPECT_EQ(run(pack("p") + " --quiet").exit_code, 0);
}

TEST_F(UnitPack, AnInputThatIsGoneOrAnotherIsOneLine) {
  write_text(folder_ / "sheet.ply", read_text(folder_ / "sheet.ply") + "\n");
  EXPECT_THAT(refusal(pack("p.zip")), AllOf(HasSubstr("sheet.ply"), HasSubstr("other content")));
  fs::remove(folder_ / "sheet.ply");
  EXPECT_THAT(refusal(pack("p.zip")), AllOf(HasSubstr("sheet.ply"), HasSubstr("is missing")));
}

TEST_F(UnitPack, AnotherStudyIsNotThatOfTheResults) {
  write_text(folder_ / "studies" / "s.json",
             R"({"format": "pellucid-study", "version": 1, "scenes": ["../scene.json"],
                 "reference": "raytrace", "methods": ["weighted-average"], "repeats": 2})");
  EXPECT_THAT(refusal(pack("p.zip")), HasSubstr("is not what"));
  EXPECT_THAT(refusal("pack " + file("studies") + " -o " + file("p.zip")),
              HasSubstr("has no results.json"));
}

/// A warning says names as a file has them.
TEST_F(UnitPack, WarningsOfRunsAreALineEach) {
  ASSERT_EQ(shell("cp -r results after"), 0);
  const fs::path results = folder_ / "after/results.json";
  nlohmann::json json = nlohmann::json::parse(read_text(results));
  for (nlohmann::json& row : json["rows"]) row["machine"]["commit"] = "one\ntwo";
  write_text(results, json.dump());
  EXPECT_THAT(run("compare " + file("results") + " " + file("after")).err,
              HasSubstr(R"(one\ntwo)"));
}

TEST_F(UnitPack, TwoRunsCompareAsTheirExitCodesSay) {
  ASSERT_EQ(shell("cp -r results after"), 0);
  const std::string both = "compare " + file("results") + " " + file("after");
  EXPECT_EQ(run(both).exit_code, 0);
  fs::remove(folder_ / "after/images/scene/raytrace.exr");
  EXPECT_EQ(run(both + " --ignore-times --quiet").exit_code, 1);
  EXPECT_THAT(refusal(both + " --metric rmse"), HasSubstr("no option of pictures"));
  EXPECT_THAT(refusal("compare " + file("results") + " " + file("sheet.ply")),
              HasSubstr("has no results.json"));
}

}  // namespace
}  // namespace pellucid::app
