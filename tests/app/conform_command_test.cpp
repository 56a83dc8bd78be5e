// SPDX-License-Identifier: GPL-3.0-or-later
// `pellucid conform`: what it refuses, and what it leaves. Verdicts: tests/compare/conform.
#include <nlohmann/json.hpp>

#include "core/files/json_text.h"
#include "core/files/output_file.h"
#include "tests/app/command_line.h"

namespace pellucid::app {
namespace {

using ::testing::HasSubstr;

class UnitConformCommand : public UnitCommandLine {
 protected:
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
};

TEST_F(UnitConformCommand, NamesAProgramThatIsNotThere) {
  EXPECT_THAT(refusal("conform --command 'no-such-program {output}'"),
              HasSubstr("no-such-program"));
}

TEST_F(UnitConformCommand, RefusesWhatWouldBeJudgedTwiceOrReportedNowhere) {
  EXPECT_THAT(refusal("conform --renderers list.json"), HasSubstr("with --report FOLDER"));
  EXPECT_THAT(refusal("conform -m raytrace --renderers list.json --report r"),
              HasSubstr("one of --command"));
  EXPECT_THAT(refusal("conform --make x --report r"), HasSubstr("with what is to be judged"));
  EXPECT_THAT(refusal("conform --renderers nowhere.json --report " + path("r")),
              HasSubstr("nowhere.json"));
  EXPECT_FALSE(fs::exists(path("r")));
}

/// Also of one renderer; a folder with somebody's files stays as it is.
TEST_F(UnitConformCommand, ReportsOneRendererOrAList) {
  EXPECT_EQ(run("conform -m raytrace --only layers-2 --report " + path("one")).exit_code, 0);
  EXPECT_EQ(read_json(folder_ / "one/results.json")["renderers"][0]["name"], "raytrace");
  write_text(folder_ / "list.json", R"({"renderers": ["raytrace", "weighted-average"]})");
  const Outcome two =
      run("conform --only layers-2 --renderers " + path("list.json") + " --report " + path("two"));
  EXPECT_EQ(two.exit_code, 1);
  EXPECT_THAT(two.out, HasSubstr("0 of 1 pass"));
  EXPECT_THAT(two.err, HasSubstr("1 of 2 cases failed"));
  EXPECT_THAT(read_text(folder_ / "two/report.html"), HasSubstr("misordered"));
  const Outcome json = run("conform --only layers-2 --json --renderers " + path("list.json") +
                           " --report " + path("two"));
  EXPECT_EQ(nlohmann::json::parse(json.out), read_json(folder_ / "two/results.json"));
  fs::create_directory(folder_ / "mine");
  write_text(folder_ / "mine/notes.txt", "mine");
  EXPECT_THAT(refusal("conform -m raytrace --only layers-2 --report " + path("mine")),
              HasSubstr("mine"));
  EXPECT_EQ(read_text(folder_ / "mine/notes.txt"), "mine");
}

}  // namespace
}  // namespace pellucid::app
