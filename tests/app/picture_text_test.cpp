// SPDX-License-Identifier: GPL-3.0-or-later
// What files of pictures say of themselves, whoever writes them.
#include "compare/pictures/image_file.h"
#include "tests/app/command_line.h"

namespace pellucid::app {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class UnitPictureText : public UnitCommandLine {
 protected:
  void SetUp() override {
    UnitCommandLine::SetUp();
    write_text(scene(), R"({"format": "pellucid-scene", "version": 1, "resolution": [40, 30],
      "camera": {"eye": [0.125, 0, 5]},
      "objects": [{"mesh": "sheet.ply", "importance": 0.5},
                  {"dataset": "stack:layers=3", "opacity": 0.3, "importance": 0.25}]})");
  }
  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  void call(const std::string& arguments) const {
    const Outcome outcome = run(arguments);
    ASSERT_EQ(outcome.exit_code, 0) << arguments << ": " << outcome.err;
  }
  std::string text(const std::string& name) const { return read_text(folder_ / name); }
};

TEST_F(UnitPictureText, LayersAndSumsSayWhatTheyAreOf) {
  call(render("weighted-average", "a.exr") + " --layers " + file("l.exr") + " --sums " +
       file("s.exr"));
  call(render("weighted-average", "a.png") + " --layers " + file("l.png"));
  for (const char* name : {"a.exr", "a.png", "l.exr", "l.png", "s.exr"})
    EXPECT_THAT(text(name), AllOf(HasSubstr("Software"), HasSubstr("weighted-average"),
                                  HasSubstr("eye=0.125,0,5"), HasSubstr("Values")))
        << name;
  EXPECT_THAT(text("l.exr"), AllOf(HasSubstr("layers per pixel"), Not(HasSubstr("background"))));
}

TEST_F(UnitPictureText, OptimizedOpacitiesAreTold) {
  const std::string optimized = " --opacities fourier-opacity:bands=3";
  call(render("raytrace", "a.exr") + optimized);
  EXPECT_THAT(text("a.exr"), AllOf(HasSubstr("raytrace"), HasSubstr("fourier-opacity:bands=3")));
  call(render("raytrace", "b.exr") + optimized + " --deep " + file("deep.exr"));
  call("merge --quiet " + file("deep.exr") + " -o " + file("merged.exr"));
  EXPECT_EQ(text("merged.exr"), text("a.exr"));
  call("frames " + scene().string() + " --quiet -m raytrace --orbit 5 --frames 2 -o " +
       file("frames") + optimized);
  EXPECT_THAT(text("frames/0001.png"), HasSubstr("fourier-opacity:bands=3"));
}

TEST_F(UnitPictureText, APartSaysWhichOneItIs) {
  for (const std::string part : {"1", "2"}) {
    call(render("raytrace", part + ".png") + " --part " + part + "/2 --deep " +
         file(part + ".exr"));
    EXPECT_THAT(text(part + ".png"), AllOf(HasSubstr("Part"), HasSubstr(part + "/2")));
  }
  call("merge --quiet " + file("1.exr") + " " + file("2.exr") + " -o " + file("all.exr"));
  call(render("raytrace", "whole.exr"));
  EXPECT_EQ(text("all.exr"), text("whole.exr"));
}

TEST_F(UnitPictureText, ExportsAndConformanceScenesHaveItToo) {
  call("export " + scene().string() + " --quiet -o " + file("out"));
  EXPECT_THAT(text("out/reference.exr"),
              AllOf(HasSubstr("raytrace"), HasSubstr("eye=0.125,0,5"), HasSubstr("background")));
  call("conform --quiet --make " + file("cases") + " --only layers-1");
  EXPECT_THAT(text("cases/layers-1/expected.exr"), HasSubstr("closed form"));
}

TEST_F(UnitPictureText, MapsSayWhatTheirColoursAre) {
  call(render("raytrace", "a.exr"));
  call(render("weighted-blended", "b.exr"));
  call("compare " + file("a.exr") + " " + file("b.exr") + " --diff " + file("d.png") +
       " --flip-map " + file("f.exr"));
  EXPECT_THAT(text("d.png"), AllOf(HasSubstr("Software"), HasSubstr("logarithmic")));
  EXPECT_THAT(text("f.exr"), AllOf(HasSubstr("Software"), HasSubstr("FLIP's error")));
}

/// Premultiplied in floats, straight in 8 bits: `compare` is not silent about it.
TEST_F(UnitPictureText, StraightAndPremultipliedColoursAreToldApart) {
  for (const char* name : {"none.exr", "none.png"})
    call(render("raytrace", name) + " --background none");
  EXPECT_THAT(text("none.exr"), AllOf(HasSubstr("premultiplied by A, without a background"),
                                      Not(HasSubstr("straight"))));
  EXPECT_THAT(text("none.png"), AllOf(HasSubstr("straight colour, not multiplied by A"),
                                      Not(HasSubstr("premultiplied"))));
  const auto note = [&](const std::string& a, const std::string& b) {
    const std::string call = "compare " + file(a) + " " + file(b);
    const auto json = nlohmann::json::parse(run(call + " --json").out);
    const std::string said = json.value("note", "");
    EXPECT_EQ(run(call).out.find("note: " + said) == std::string::npos, said.empty());
    return said;
  };
  EXPECT_THAT(note("none.exr", "none.png"), HasSubstr("TEST looks to have straight colours"));
  EXPECT_THAT(note("none.png", "none.exr"), HasSubstr("REFERENCE looks to have straight colours"));
  EXPECT_EQ(note("none.exr", "none.exr"), "");
  call(render("weighted-sum", "other.exr") + " --background none");
  EXPECT_EQ(note("none.exr", "other.exr"), "");  // an error of a method is none of form
}

}  // namespace
}  // namespace pellucid::app
