// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/command_line.h"

namespace pellucid::app {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

/// A pair of pictures of a sheet, with their layers, and a mask of the picture's left half.
class UnitCompareCommand : public UnitCommandLine {
 protected:
  void SetUp() override {
    UnitCommandLine::SetUp();
    for (const char* method : {"raytrace", "weighted-blended"})
      ASSERT_EQ(run(render(method, std::string(method) + ".exr") + " --layers " +
                    (folder_ / (std::string(method) + ".layers.exr")).string())
                    .exit_code,
                0);
    write_text(folder_ / "left.pgm", "P5 96 96 255\n" + half());
    write_text(folder_ / "black.pgm", "P5 2 2 255\n" + std::string(4, '\0'));
    write_text(folder_ / "small.pgm", "P5 2 2 255\n" + std::string(4, '\xff'));
    write_text(folder_ / "empty.pgm", "P5 96 96 255\n" + std::string(96 * 96, '\0'));
  }

  static std::string half() {
    std::string row = std::string(48, '\xff') + std::string(48, '\0'), all;
    for (int y = 0; y < 96; ++y) all += row;
    return all;
  }
  std::string pair() const {
    return "compare " + (folder_ / "raytrace.exr").string() + " " +
           (folder_ / "weighted-blended.exr").string() + " ";
  }
  std::string file(const char* name) const { return (folder_ / name).string(); }
  nlohmann::json numbers(const std::string& options) const {
    const Outcome outcome = run(pair() + "--json " + options);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return nlohmann::json::parse(outcome.out);
  }
};

TEST_F(UnitCompareCommand, PrintsNumbersOverEveryRegionThatIsKnown) {
  const nlohmann::json all = numbers("");
  for (const char* name : {"rmse", "psnr", "ssim", "max_error", "flip", "p99", "bias_r", "covered",
                           "rmse_covered", "ssim_covered", "flip_covered", "rmse_equal"})
    EXPECT_TRUE(all.at(name).is_number()) << name;
  EXPECT_TRUE(all.at("ms_ssim").is_null());  // 96 pixels are too few
  EXPECT_TRUE(all.at("displayed").at("flip").is_number());
  fs::remove(folder_ / "raytrace.layers.exr");
  EXPECT_FALSE(numbers("").contains("rmse_covered"));
}

/// White before white: colours are equal, and metrics are of colours.
TEST_F(UnitCompareCommand, PicturesOfOtherOpacitiesAreNotEqualInSilence) {
  for (const char* opacity : {"0.25", "0.75"}) {
    write_text(scene(), std::string(R"({"format": "pellucid-scene", "version": 1,
        "resolution": [32, 32], "background": [1, 1, 1], "objects": [{"mesh": "sheet.ply",
        "color": [1, 1, 1], "opacity": )") +
                            opacity + "}]}");
    ASSERT_EQ(run(render("raytrace", std::string(opacity) + ".exr")).exit_code, 0);
  }
  const std::string pair = "compare " + file("0.25.exr") + " " + file("0.75.exr") + " ";
  const nlohmann::json json = nlohmann::json::parse(run(pair + "--json").out);
  EXPECT_EQ(json.at("rmse"), 0);
  EXPECT_EQ(json.at("max_alpha_error"), 0.5);
  EXPECT_THAT(run(pair).out, HasSubstr("opacity, which no number above counts"));
  EXPECT_EQ(numbers("").count("max_alpha_error"), 1u);
}

TEST_F(UnitCompareCommand, TakesPartsOfThePictures) {
  const nlohmann::json all = numbers("--metric rmse,max_error");
  const nlohmann::json cut = numbers("--metric rmse --crop 0,0,48,96");
  const nlohmann::json masked = numbers("--metric rmse --mask " + file("left.pgm"));
  EXPECT_EQ(cut, masked);  // of the same pixels
  EXPECT_NE(cut["rmse"], all["rmse"]);
  EXPECT_TRUE(all.contains("max_error_pixel"));
  EXPECT_EQ(cut.size(), 3u) << cut;  // rmse, the same of 8 bits, covered
}

TEST_F(UnitCompareCommand, RepeatsWhatOthersPrintOnRequest) {
  const nlohmann::json others = numbers("--metric ssim_skimage --metric ssim_luma8");
  EXPECT_TRUE(others.at("ssim_skimage").is_number());
  EXPECT_TRUE(others.at("ssim_luma8").is_number());
  EXPECT_FALSE(numbers("").contains("ssim_skimage"));
}

/// As of pictures that are given to a study. Numbers and exit code are as without it.
TEST_F(UnitCompareCommand, SaysWhatLooksWrongWithThePictureAsAWhole) {
  EXPECT_EQ(numbers("").at("faults"), nlohmann::json::array());
  for (const std::string up : {"1", "-1"}) {
    write_text(scene(), R"({"format": "pellucid-scene", "version": 1, "resolution": [96, 96],
        "camera": {"type": "orthographic", "eye": [0, 0, 5], "target": [0, 0, 0], "height": 3,
        "up": [0, )" + up + R"(, 0]}, "objects": [{"mesh": "sheet.ply"}]})");
    ASSERT_EQ(run(render("raytrace", up + ".exr")).exit_code, 0);
  }
  const std::string turned = "compare " + file("1.exr") + " " + file("-1.exr") + " ";
  const Outcome outcome = run(turned + "--json");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(nlohmann::json::parse(outcome.out).at("faults"),
            nlohmann::json::array({"looks turned by 180 degrees"}));
  EXPECT_THAT(run(turned).out, HasSubstr("note: TEST looks turned by 180 degrees\n"));
  EXPECT_THAT(run(turned + "--metric rmse").out, ::testing::Not(HasSubstr("note:")));
  EXPECT_THAT(run(turned + "--mask " + file("left.pgm")).out, ::testing::Not(HasSubstr("note:")));
}

TEST_F(UnitCompareCommand, EveryMetricHasAThreshold) {
  EXPECT_EQ(run(pair() + "--fail-flip 1 --fail-bias-r 1 --fail-ssim-covered -1").exit_code, 0);
  EXPECT_THAT(refusal(pair() + "--fail-flip -1", 1), HasSubstr("is above --fail-flip -1"));
  EXPECT_THAT(refusal(pair() + "--fail-ssim-luma8 2", 1), HasSubstr("is below"));
  EXPECT_THAT(refusal(pair() + "--fail-bias-r -0.5", 1), HasSubstr("Bias, red"));
  EXPECT_THAT(refusal(pair() + "--fail-ms-ssim 0"), HasSubstr("larger ones"));
}

TEST_F(UnitCompareCommand, WritesFlipsMap) {
  EXPECT_EQ(run(pair() + "--flip-map " + file("flip.png")).exit_code, 0);
  EXPECT_EQ(run(pair() + "--flip-map " + file("flip.exr")).exit_code, 0);
  EXPECT_TRUE(fs::exists(folder_ / "flip.png"));
  const Outcome outcome =
      run("compare --json --metric max_error " + file("flip.exr") + " " + file("flip.exr"));
  EXPECT_THAT(outcome.out, HasSubstr("\"max_error\": 0.0"));
}

TEST_F(UnitCompareCommand, RefusesWhatDoesNotFit) {
  EXPECT_THAT(refusal(pair() + "--mask " + file("small.pgm")),
              HasSubstr("small.pgm: 2×2 pixels; accepted: 96×96"));
  EXPECT_THAT(refusal(pair() + "--mask " + file("empty.pgm")), HasSubstr("no pixel counts"));
  EXPECT_THAT(refusal(pair() + "--mask " + file("left.pgm") + " --crop 60,0,9,9"),
              HasSubstr("within the crop"));
  for (const char* crop : {"90,0,10,10", "0,0,0,5", "-1,0,5,5", "0,0,5,2147483647"})
    EXPECT_THAT(refusal(pair() + "--crop=" + crop), HasSubstr("within 96×96 pixels")) << crop;
  EXPECT_THAT(refusal(pair() + "--metric msssim"), HasSubstr("ms_ssim"));
  fs::remove(folder_ / "raytrace.layers.exr");
  EXPECT_THAT(refusal(pair() + "--metric rmse_covered"), HasSubstr("accepted: --layers FILE.exr"));
  EXPECT_THAT(refusal(pair() + "--fail-rmse-covered 1"), HasSubstr("accepted: --layers FILE.exr"));
  EXPECT_THAT(refusal(pair() + "--layers " + file("left.pgm")), HasSubstr("left.pgm"));
}

}  // namespace
}  // namespace pellucid::app
