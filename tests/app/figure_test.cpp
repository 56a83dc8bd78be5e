// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/command_line.h"

namespace pellucid::app {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

/// The results of a study of the sheet.
class UnitFigure : public UnitCommandLine {
 protected:
  void SetUp() override {
    UnitCommandLine::SetUp();
    write_text(folder_ / "s.json",
               R"({"format": "pellucid-study", "version": 1, "scenes": ["scene.json"],
                   "reference": "raytrace", "methods": ["weighted-average"], "repeats": 1})");
    ASSERT_EQ(run("study " + file("s.json") + " --quiet -o " + file("results")).exit_code, 0);
  }

  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  std::string figure(const std::string& more, const std::string& output = "f.pdf") const {
    return "figure " + file("results") + " -o " + file(output) + " " + more;
  }
};

TEST_F(UnitFigure, OneCommandMakesEachFormatAndTellsWhatItShows) {
  for (const char* output : {"f.pdf", "f.svg", "f.png", "f.tex"}) {
    const Outcome outcome = run(figure("--error --flip", output));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.out,
                AllOf(HasSubstr(output), HasSubstr("181.9"), HasSubstr("--crop scene=")));
    EXPECT_TRUE(fs::exists(folder_ / output));
  }
  const Outcome outcome =
      run(figure("--json --width eg --methods weighted-average,raytrace "
                 "--crop 1,2,30,40 --crop scene=0,0,96,96",
                 "f.tex"));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const nlohmann::json json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["files"].size(), 2u);
  EXPECT_NEAR(json["width_mm"].get<double>(), 84, 1e-9);
  EXPECT_EQ(json["scenes"][0]["name"], "scene");
  EXPECT_EQ(json["scenes"][0]["methods"], nlohmann::json({"weighted-average", "raytrace"}));
  EXPECT_EQ(json["scenes"][0]["crops"], nlohmann::json::parse("[[1, 2, 30, 40], [0, 0, 96, 96]]"));
}

TEST_F(UnitFigure, WithoutCropsAndNumbersThereArePicturesAlone) {
  const Outcome outcome = run(figure("--crop none --numbers none --json"));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const nlohmann::json json = nlohmann::json::parse(outcome.out);
  EXPECT_TRUE(json["scenes"][0]["crops"].empty());
  // Two squares beside each other, and a line of headings above.
  EXPECT_LT(json["height_mm"].get<double>(), json["width_mm"].get<double>() / 2 + 8);
}

TEST_F(UnitFigure, AnSvgIsTheSameOnEachRun) {
  ASSERT_EQ(run(figure("--quiet", "f.svg")).exit_code, 0);
  ASSERT_EQ(run(figure("--quiet", "g.svg")).exit_code, 0);
  EXPECT_TRUE(read_text(folder_ / "f.svg") == read_text(folder_ / "g.svg"));
}

TEST_F(UnitFigure, WhatIsWrongIsOneLineAndLeavesNothing) {
  EXPECT_THAT(refusal(figure("", "f.eps")), HasSubstr("ending '.eps'; accepted: .pdf, .svg"));
  EXPECT_THAT(refusal(figure("", "none/f.pdf")), HasSubstr("none"));
  EXPECT_THAT(refusal(figure("--scene scena")), HasSubstr("unknown scene 'scena'; known: scene"));
  EXPECT_THAT(refusal(figure("--methods weighted-avarage")), HasSubstr("known: weighted-average"));
  EXPECT_THAT(refusal(figure("--crop 90,0,7,5")), HasSubstr("96×96"));
  EXPECT_THAT(refusal(figure("--crop 9,0,7")), HasSubstr("--crop: '9,0,7'; accepted: X,Y"));
  EXPECT_THAT(refusal(figure("--crop=-1,0,7,7")), HasSubstr("--crop"));
  EXPECT_THAT(refusal(figure("--crop a=1,0,7,7")), HasSubstr("'a' is no scene"));
  EXPECT_THAT(refusal(figure("--table")), HasSubstr("accepted for a table: .tex"));
  EXPECT_THAT(refusal(figure("--table --numbers none", "f.tex")), HasSubstr("--numbers"));
  EXPECT_THAT(refusal(figure("--width wide")), HasSubstr("unknown width 'wide'; known: "));
  EXPECT_THAT(refusal(figure("--numbers rsme")), HasSubstr("known: rmse"));
  EXPECT_THAT(refusal(figure("--label one")), HasSubstr("accepted: 2"));
  EXPECT_THAT(refusal(figure("--width 20 --font-size 20")), HasSubstr("do not fit"));
  EXPECT_THAT(refusal("figure " + folder_.path().string() + " -o " + file("f.pdf")),
              HasSubstr("has no results.json"));
  fs::remove_all(folder_ / "results/images");
  EXPECT_THAT(refusal(figure("")), HasSubstr("raytrace.exr: is missing"));
}

TEST_F(UnitFigure, ItsOwnInputIsNotWrittenOver) {
  const fs::path png = folder_ / "results/images/scene/raytrace.exr";
  fs::create_symlink(png, folder_ / "f.png");
  const std::string before = read_text(png);
  EXPECT_EQ(run(figure("", "f.png")).exit_code, 2);
  EXPECT_EQ(read_text(png), before);
}

}  // namespace
}  // namespace pellucid::app
