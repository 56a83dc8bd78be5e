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
    EXPECT_THAT(read_text(folder_ / name),
                AllOf(HasSubstr("Software"), HasSubstr("pellucid "), HasSubstr("scene"),
                      HasSubstr("raytrace"), HasSubstr("eye=0.125,0,5"),
                      HasSubstr("over the background 1, 1, 1; A = 1 - transmittance"),
                      Not(HasSubstr(folder_.path().string()))))
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
