// SPDX-License-Identifier: GPL-3.0-or-later
// `pellucid render --part` and `pellucid merge`: a picture from parts of a scene.
#include "tests/app/command_line.h"

namespace pellucid::app {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class UnitMerge : public UnitCommandLine {
 protected:
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string render_part(const std::string& part, const std::string& file,
                          const std::string& more = "") const {
    return "render " + scene().string() + " --quiet -m raytrace --part " + part + " --deep " +
           path(file) + ' ' + more;
  }
  void SetUp() override {
    UnitCommandLine::SetUp();
    write_text(scene(), R"({"format": "pellucid-scene", "version": 1, "resolution": [40, 30],
      "lighting": "headlight",
      "objects": [{"mesh": "sheet.ply"}, {"dataset": "stack:layers=5", "opacity": 0.3},
                  {"isosurface": {"dataset": "sphere-levels:levels=1", "scalar": "q", "value": 0.1},
                   "opacity": 0.4}]})");
  }
};

TEST_F(UnitMerge, IsThePictureOfTheWholeScene) {
  for (const std::string part : {"1", "2", "3"}) {
    const Outcome outcome = run(render_part(part + "/3", part + ".exr"));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
  }
  const Outcome whole =
      run(render("raytrace", "whole.exr") + " --json --deep " + path("whole-deep.exr"));
  ASSERT_EQ(whole.exit_code, 0) << whole.err;
  const Outcome outcome =
      run("merge " + path("2.exr") + ' ' + path("1.exr") + ' ' + path("3.exr") +
          " --json --quiet -o " + path("merged.exr") + " --deep " + path("deep.exr"));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(read_text(path("merged.exr")), read_text(path("whole.exr")));
  EXPECT_EQ(read_text(path("deep.exr")), read_text(path("whole-deep.exr")));
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json.at("parts"), 3);
  EXPECT_EQ(json.at("fragments"), nlohmann::json::parse(whole.out).at("fragments"));
  EXPECT_GT(json.at("fragments"), 100);
}

/// None is no colour, whoever composites: the file is the whole's, channels and texts included.
TEST_F(UnitMerge, WithoutABackgroundItIsThePictureOfTheWholeToo) {
  const std::string none = " --background none";
  for (const std::string part : {"1", "2"})
    ASSERT_EQ(run(render_part(part + "/2", part + ".exr", none)).exit_code, 0);
  for (const std::string ending : {".exr", ".png"}) {
    ASSERT_EQ(run(render("raytrace", "whole" + ending) + none).exit_code, 0);
    ASSERT_EQ(run("merge " + path("1.exr") + ' ' + path("2.exr") + " --quiet -o " +
                  path("merged" + ending))
                  .exit_code,
              0);
    EXPECT_EQ(read_text(path("merged" + ending)), read_text(path("whole" + ending))) << ending;
    ASSERT_EQ(run(render_part("1/1", "all.npz", none + " -o " + path("all" + ending))).exit_code,
              0);
    EXPECT_EQ(read_text(path("all" + ending)), read_text(path("whole" + ending))) << ending;
  }
  EXPECT_EQ(nlohmann::json::parse(run("info --json " + path("1.exr")).out).at("background"),
            "none");
  ASSERT_EQ(run(render_part("2/2", "black.exr", "--background black")).exit_code, 0);
  EXPECT_THAT(
      refusal("merge " + path("1.exr") + ' ' + path("black.exr") + " --quiet -o " + path("m.exr")),
      HasSubstr("its background is 0,0,0, of " + path("1.exr") + " it is none"));
}

/// Each file is there as it was, but not where it was.
TEST_F(UnitMerge, FilesOfOneNameThatHaveChangedPlacesAreAnotherScene) {
  fs::create_directory(folder_ / "x");
  fs::create_directory(folder_ / "y");
  const std::string sheet = read_text(folder_ / "sheet.ply");
  std::string other = sheet;
  other.replace(other.find("0.75"), 4, "0.25");
  write_text(scene(), R"({"format": "pellucid-scene", "version": 1, "resolution": [40, 30],
    "objects": [{"mesh": "x/m.ply", "color": "red"}, {"mesh": "y/m.ply", "color": "blue"}]})");
  write_text(folder_ / "x/m.ply", sheet);
  write_text(folder_ / "y/m.ply", other);
  // Both parts are drawn with the camera of either: the sheets cover the same triangle.
  ASSERT_EQ(run(render_part("1/2", "1.exr")).exit_code, 0);
  write_text(folder_ / "x/m.ply", other);
  write_text(folder_ / "y/m.ply", sheet);
  ASSERT_EQ(run(render_part("2/2", "2.exr")).exit_code, 0);
  EXPECT_THAT(
      refusal("merge " + path("1.exr") + ' ' + path("2.exr") + " --quiet -o " + path("m.exr")),
      HasSubstr("its content of the scene is"));
}

TEST_F(UnitMerge, WhatIsForNumPyIsNotCalledDamaged) {
  ASSERT_EQ(run(render_part("1/2", "1.exr")).exit_code, 0);
  ASSERT_EQ(run(render_part("2/2", "2.npz")).exit_code, 0);
  EXPECT_THAT(
      refusal("merge " + path("1.exr") + ' ' + path("2.npz") + " --quiet -o " + path("m.exr")),
      HasSubstr("2.npz: .npz is not merged; accepted: .exr"));
}

TEST_F(UnitMerge, APartIsDrawnAndCounted) {
  const Outcome outcome = run(render_part("1/1", "all.npz", "--json -o " + path("all.exr")));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(nlohmann::json::parse(outcome.out).at("part"), nlohmann::json({1, 1}));
  ASSERT_EQ(run(render("raytrace", "whole.exr")).exit_code, 0);
  EXPECT_EQ(read_text(path("all.exr")), read_text(path("whole.exr")));
}

TEST_F(UnitMerge, WrongCallsAreRefused) {
  for (const char* part :
       {"0/3", "4/3", "1", "1/", "/2", "1/2/3", "a/b", "1.5/2", "-1/2", "1/65537"})
    EXPECT_THAT(refusal(render_part(part, "p.exr")), HasSubstr("--part: '")) << part;
  EXPECT_THAT(refusal(render("raytrace") + " --part 1/2"), HasSubstr("--deep"));
  EXPECT_THAT(refusal(render("fourier") + " --part 1/2 --deep " + path("p.exr")),
              AllOf(HasSubstr("--part: the method is 'fourier'"), HasSubstr("accepted: raytrace")));
  EXPECT_THAT(refusal(render_part("1/2", "p.exr", "--sums " + path("s.exr"))), HasSubstr("--sums"));
  EXPECT_THAT(refusal(render_part("1/2", "p.exr", "--samples 2")),
              HasSubstr("accepted: samples 1"));
  EXPECT_THAT(refusal("render " + scene().string() + " -m raytrace"), HasSubstr("--output"));
  EXPECT_THAT(refusal("render " + scene().string() + " -m raytrace --stats " + path("s.json") +
                      " --deep " + path("p.exr")),
              HasSubstr("--output"));
}

TEST_F(UnitMerge, WhatAreNotAllPartsOfOneSceneIsRefused) {
  ASSERT_EQ(run(render_part("1/2", "1.exr")).exit_code, 0);
  ASSERT_EQ(run(render_part("2/2", "2.exr", "--view +x")).exit_code, 0);
  const std::string output = " --quiet -o " + path("m.exr");
  EXPECT_THAT(refusal("merge " + path("1.exr") + ' ' + path("2.exr") + output),
              HasSubstr("2.exr: its camera is"));
  EXPECT_THAT(refusal("merge " + path("1.exr") + output), HasSubstr("part 2 of 2 is missing"));
  write_text(folder_ / "sheet.ply", read_text(folder_ / "sheet.ply") + " ");
  ASSERT_EQ(run(render_part("2/2", "2.exr")).exit_code, 0);
  EXPECT_THAT(refusal("merge " + path("1.exr") + ' ' + path("2.exr") + output),
              HasSubstr("2.exr: its content of the scene is"));
  EXPECT_THAT(refusal("merge " + path("1.exr")), HasSubstr("--output, --deep or --partial"));
  EXPECT_THAT(refusal("merge " + path("1.exr") + " -o " + path("1.exr")), HasSubstr("1.exr"));
  EXPECT_THAT(refusal("merge " + scene().string() + output), HasSubstr("scene.json"));
}

}  // namespace
}  // namespace pellucid::app
