// SPDX-License-Identifier: GPL-3.0-or-later
// What the files of pictures hold, and that no two outputs are one file.
#include "compare/pictures/image_file.h"
#include "tests/app/command_line.h"

namespace pellucid::app {
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

class UnitRenderOutputs : public UnitCommandLine {
 protected:
  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  Image drawn(const std::string& options, const std::string& name = "a.exr") const {
    const Outcome outcome = run(render("raytrace", name) + " " + options);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return compare::read_image(folder_ / name);
  }
};

TEST_F(UnitRenderOutputs, PicturesSayWhatTheyAreOf) {
  for (const char* name : {"a.exr", "a.png"}) {
    drawn("--camera eye=0.125,0,5", name);
    EXPECT_THAT(
        read_text(folder_ / name),
        AllOf(HasSubstr("Software"), HasSubstr("pellucid "), HasSubstr("scene"),
              HasSubstr("raytrace"), HasSubstr("eye=0.125,0,5"),
              HasSubstr("over the background 1, 1, 1; "), Not(HasSubstr(folder_.path().string()))))
        << name;
  }
}

TEST_F(UnitRenderOutputs, WithoutABackgroundColoursArePremultiplied) {
  const Image over = drawn(""), none = drawn("--background none"),
              red = drawn("--background '#f00'");
  const auto middle = [](const Image& image) { return image.at(48, 60); };
  const Rgba premultiplied = middle(none);
  EXPECT_EQ(none.at(0, 0), Rgba(0));
  EXPECT_EQ(red.at(0, 0), Rgba(1, 0, 0, 0));
  ASSERT_GT(premultiplied.a, 0.1f);
  EXPECT_EQ(premultiplied.a, middle(over).a);
  const float left = 1 - premultiplied.a;
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(premultiplied[c] + left, middle(over)[c], 1e-6) << c;
    EXPECT_NEAR(premultiplied[c] + (c == 0 ? left : 0), middle(red)[c], 1e-6) << c;
  }
  EXPECT_THAT(read_text(folder_ / "a.exr"), HasSubstr("over the background 1, 0, 0"));
}

/// An 8-bit picture has straight colours: they and alpha are right to half a step.
TEST_F(UnitRenderOutputs, APngWithoutABackgroundHasAlpha) {
  const Image exact = drawn("--background none"), png = drawn("--background none", "a.png");
  EXPECT_EQ(png.at(0, 0), Rgba(0));
  const Rgba a = exact.at(48, 60), b = png.at(48, 60);
  EXPECT_NEAR(b.a, a.a, 0.5 / 255 + 1e-6);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(b[c], a[c] / a.a, 0.5 / 255 + 1e-6);
  EXPECT_THAT(refusal(render("raytrace") + " --background nun"), HasSubstr("none"));
}

/// More than one tile each way.
TEST_F(UnitRenderOutputs, TilesAreTheSamePicture) {
  const Image whole = drawn("--resolution 300x270"),
              tiled = drawn("--resolution 300x270 --tiles", "tiled.exr");
  EXPECT_TRUE(tiled.pixels == whole.pixels);
  EXPECT_THAT(read_text(folder_ / "tiled.exr"), HasSubstr("raytrace"));
  EXPECT_THAT(refusal(render("raytrace", "b.png") + " --tiles"), HasSubstr("accepted: an .exr"));
  EXPECT_THAT(refusal(render("linked-list", "b.exr") + " --tiles"), HasSubstr("raytrace"));
  EXPECT_THAT(refusal(render("raytrace:adaptive=4", "b.exr") + " --tiles"),
              HasSubstr("adaptive=1"));
  EXPECT_THAT(refusal(render("raytrace", "b.exr") + " --resolution 16385x1"),
              HasSubstr("with --tiles 1 … 32768"));
  EXPECT_THAT(refusal(render("raytrace", "b.exr") + " --tiles --resolution 32769x1"),
              HasSubstr("each 1 … 32768"));
  EXPECT_THAT(refusal(render("raytrace", "b.exr") + " --tiles --layers " + file("l.exr")),
              HasSubstr("--layers"));
  EXPECT_FALSE(fs::exists(folder_ / "b.exr"));
}

TEST_F(UnitRenderOutputs, APictureThatIsNotFiniteIsAFailure) {
  write_text(folder_ / "none.json", R"({"format": "pellucid-glsl-method", "version": 1,
    "title": "None", "passes": [{"step": "composite", "screen": "none.glsl"}]})");
  write_text(folder_ / "none.glsl",
             "void main() { picture = vec4(0, 1, 2, 3) * (1.0 / (behind().r - behind().r)); }\n");
  const Outcome outcome = run(render("glsl:file=" + file("none.json"), "none.exr"));
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("of its picture's pixels are not finite"));
  EXPECT_FALSE(fs::exists(folder_ / "none.exr"));
}

TEST_F(UnitRenderOutputs, TwoOutputsOfOneFileAreRefused) {
  EXPECT_THAT(refusal(render("raytrace", "a.exr") + " --layers " + file("a.exr")),
              AllOf(HasSubstr("--output"), HasSubstr("--layers"), HasSubstr("a file for each")));
  EXPECT_NE(refusal(render("raytrace") + " --stats " + file("./a.png")), "");
  fs::create_symlink(folder_ / "a.exr", folder_ / "link.exr");
  EXPECT_NE(refusal(render("raytrace", "a.exr") + " --deep " + file("link.exr")), "");
  EXPECT_EQ(
      run(render("raytrace") + " --stats /dev/null --probe 1,1 --probe-out /dev/null").exit_code,
      0);
}

TEST_F(UnitRenderOutputs, ARefusedCallLeavesNoFile) {
  const std::string more =
      " --samples 2 --probe 1,1 --probe-out " + file("p.json") + " --sums " + file("s.exr");
  EXPECT_THAT(refusal(render("raytrace") + more + " --deep " + file("d.exr")), HasSubstr("--deep"));
  const std::string refused = "raytrace:adaptive=2";  // once it sees how many samples are taken
  EXPECT_THAT(refusal(render(refused) + more), HasSubstr("adaptive=2"));
  EXPECT_THAT(refusal("frames " + scene().string() + " --quiet -m " + refused +
                      " --samples 2 --orbit 9 --frames 2 -o " + file("frames")),
              HasSubstr("adaptive=2"));
}

TEST_F(UnitRenderOutputs, AnExplanationIsPartOfTheJson) {
  const Outcome outcome = run(render("raytrace") + " --json --explain");
  const auto lines = nlohmann::json::parse(outcome.out).at("explanation");
  EXPECT_THAT(lines.at(0).get<std::string>(), HasSubstr("camera: eye="));
  EXPECT_GT(lines.size(), 2u);
  const std::string printed = run(render("raytrace") + " --explain").out;
  for (const auto& line : lines) EXPECT_THAT(printed, HasSubstr(line.get<std::string>() + "\n"));
}

/// A reader of JSON may count on a number, a text or null: null is what is not known.
TEST_F(UnitRenderOutputs, AnInfinitePsnrIsNotUnknown) {
  drawn("");
  const Outcome outcome = run("compare " + file("a.exr") + " " + file("a.exr") + " --json");
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json.at("psnr"), "inf");
  EXPECT_EQ(json.at("displayed").at("psnr"), "inf");
  EXPECT_TRUE(json.at("ms_ssim").is_null());  // the picture is too small
}

TEST_F(UnitRenderOutputs, EndingsMayBeInCapitalLetters) {
  drawn("--layers " + file("n.EXR"), "A.EXR");
  drawn("", "a.exr");
  EXPECT_EQ(read_text(folder_ / "A.EXR"), read_text(folder_ / "a.exr"));
  EXPECT_EQ(compare::read_counts(folder_ / "n.EXR").at(48, 60), 1u);
  drawn("--deep " + file("D.EXR"), "B.PNG");
}

/// Where it stands: what was printed there before stays.
TEST_F(UnitRenderOutputs, TheStandardOutputIsAFileToWriteTo) {
  const std::string stats = render("raytrace") + " --json --stats /dev/stdout";
  const std::string text = run(stats).out;  // of two equal halves
  EXPECT_EQ(text.substr(0, text.size() / 2), text.substr(text.size() / 2));
  EXPECT_TRUE(nlohmann::json::accept(text.substr(0, text.size() / 2)));
  const std::string piped = run(stats + " | cat").out;
  EXPECT_EQ(std::count(piped.begin(), piped.end(), '\n'),
            std::count(text.begin(), text.end(), '\n'));
}

TEST_F(UnitRenderOutputs, TextsThatSayNothingAreRefused) {
  for (const char* option : {"--camera", "--view", "--opacities", "--background", "--stats"})
    EXPECT_THAT(refusal(render("raytrace") + " " + option + " ''"), HasSubstr(option)) << option;
  const std::string wrong = refusal(render("raytrace") + " --background '#12'");
  EXPECT_THAT(wrong, AllOf(HasSubstr("'#12'; accepted: #rrggbb, #rgb"), Not(HasSubstr("aa"))));
  EXPECT_THAT(refusal(render("raytrace") + " --background '#11223344'"),
              HasSubstr("has an opacity"));
  write_text(scene(), R"({"format": "pellucid-scene", "version": 1, "objects": [{"dataset":
    "stack:layers=1", "importance": 0.5, "opacity": {"by": "importance", "opacities": [0, 1]}}]})");
  EXPECT_THAT(refusal(render("raytrace")),
              AllOf(HasSubstr("unknown scalar 'importance'"), Not(HasSubstr("known: \n"))));
}

TEST_F(UnitRenderOutputs, OpacitiesThatAFileDoesNotHaveAreNotCompared) {
  drawn("");
  drawn("", "a.png");
  const std::string call = "compare " + file("a.exr") + " " + file("a.png");
  EXPECT_TRUE(nlohmann::json::parse(run(call + " --json").out).at("max_alpha_error").is_null());
  EXPECT_THAT(run(call).out, Not(HasSubstr("opacity")));
}

TEST_F(UnitRenderOutputs, NumbersOfLayersAreFloats) {
  drawn("--layers " + file("n.exr"));
  EXPECT_THAT(read_text(folder_ / "n.exr"),
              HasSubstr(std::string("layers\0\2\0\0\0", 11)));  // FLOAT
  EXPECT_EQ(compare::read_counts(folder_ / "n.exr").at(48, 60), 1u);
  EXPECT_EQ(compare::read_image(folder_ / "n.exr").at(48, 60).r, 1);  // as any viewer has it
}

TEST_F(UnitRenderOutputs, FramesKnowWhatTheReferenceCovers) {
  const Outcome outcome =
      run("frames " + scene().string() + " --quiet -m weighted-blended --json " +
          "--orbit 10 --frames 2 --reference raytrace -o " + file("frames"));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, ContainsRegex("\"ssim_covered\": (1|0\\.9)"));
}

/// Probes are pixels of the first view: what they measure is that view's, however many there are.
TEST_F(UnitRenderOutputs, WhatProbesMeasureIsOfTheFirstView) {
  const auto measures = [&](const std::string& views) {
    write_text(folder_ / "study.json",
               R"({"format": "pellucid-study", "version": 1, "scenes": ["scene.json"], "repeats": 1,
                   "reference": "raytrace", "methods": ["fourier:bands=7"],
                   "probes": {"scene": [[48, 60]]}, "views": )" +
                   views + "}");
    const Outcome outcome = run("study " + file("study.json") + " --quiet -o " + file("out"));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    std::map<std::string, double> found;
    const auto json = nlohmann::json::parse(read_text(folder_ / "out/results.json"));
    for (const auto& measure : json.at("rows").at(1).at("measures"))
      if (measure.at("unit") == "%") found[measure.at("name")] = measure.at("value");
    return found;
  };
  const std::string front = R"({"eye": [0, 0, 5]})", side = R"({"eye": [4.5, 0, 2]})";
  const auto one = measures("[" + front + "]");
  EXPECT_TRUE(one.contains("optical_depth_term_5"));
  EXPECT_EQ(measures("[" + front + ", " + side + "]"), one);
}

/// From the side the sheet is narrower than from the front.
TEST_F(UnitRenderOutputs, TheCoveredShareIsTheMeanOverTheViews) {
  const auto covered = [&](const std::string& views) {
    write_text(folder_ / "study.json",
               R"({"format": "pellucid-study", "version": 1, "scenes": ["scene.json"], "repeats": 1,
                   "reference": "raytrace", "methods": ["weighted-average"], "views": )" +
                   views + "}");
    const Outcome outcome = run("study " + file("study.json") + " --quiet -o " + file("out"));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return nlohmann::json::parse(read_text(folder_ / "out/results.json"))
        .at("rows")
        .at(1)
        .at("metrics")
        .at("covered")
        .get<double>();
  };
  const std::string front = R"({"eye": [0, 0, 5]})", side = R"({"eye": [4.5, 0, 2]})";
  const double a = covered("[" + front + "]"), b = covered("[" + side + "]");
  EXPECT_GT(a, 1.5 * b);
  EXPECT_NEAR(covered("[" + front + ", " + side + "]"), (a + b) / 2, 1e-12);
}

}  // namespace
}  // namespace pellucid::app
