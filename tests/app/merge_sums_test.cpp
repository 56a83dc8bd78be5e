// SPDX-License-Identifier: GPL-3.0-or-later
// `pellucid render --partial` and `pellucid merge`: a method's picture from sums of parts.
#include "tests/app/command_line.h"

#include "compare/pictures/image_file.h"
#include "tests/support/pictures.h"

namespace pellucid::app {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class UnitMergeSums : public UnitCommandLine {
 protected:
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string render_part(const std::string& method, const std::string& part,
                          const std::string& file, const std::string& more = "") const {
    return "render " + scene().string() + " --quiet -m " + method + " --part " + part +
           " --partial " + path(file) + ' ' + more;
  }
  /// Draws parts 1 to 3 of 3; returns their files.
  std::string draw(const std::string& method, const std::string& name,
                   const std::string& more = "") const {
    std::string files;
    for (const std::string part : {"1", "2", "3"}) {
      const std::string file = name + part + ".exr";
      const Outcome outcome = run(render_part(method, part + "/3", file, more));
      EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
      files = path(file) + ' ' + files;
    }
    return files;
  }
  Outcome merge(const std::string& files, const std::string& more) const {
    return run("merge " + files + " --quiet " + more);
  }
  Image image(const std::string& name) const { return compare::read_image(path(name)); }

  void SetUp() override {
    UnitCommandLine::SetUp();
    write_text(scene(), R"({"format": "pellucid-scene", "version": 1, "resolution": [40, 30],
      "lighting": "headlight", "background": [0.2, 0.4, 0.6],
      "objects": [{"mesh": "sheet.ply"}, {"dataset": "stack:layers=5", "opacity": 0.3},
                  {"dataset": "dark-sky:count=200", "radius": 0.1, "profile": "sphere"}]})");
  }
};

TEST_F(UnitMergeSums, IsThePictureOfTheWholeScene) {
  for (const std::string method :
       {"weighted-blended", "bin-average:bins=20", "fourier:bands=3", "moment", "binning"}) {
    ASSERT_EQ(run(render(method, "whole.exr")).exit_code, 0);
    const Outcome outcome = merge(draw(method, "part"), "--json -o " + path("merged.exr"));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(nlohmann::json::parse(outcome.out).at("parts"), 3);
    EXPECT_LE(testing::largest_difference(image("merged.exr"), image("whole.exr")), 2e-3) << method;
  }
}

/// The second phase is drawn of the scene's file again: behind a link ".." leads elsewhere than the
/// text says.
TEST_F(UnitMergeSums, ASceneBehindALinkIsFoundAgain) {
  fs::create_directories(folder_ / "sub/below");
  fs::create_directory(folder_ / "here");
  fs::create_directory_symlink(folder_ / "sub/below", folder_ / "here/link");
  write_text(folder_ / "sub/scene.json", read_text(scene()));
  fs::copy_file(folder_ / "sheet.ply", folder_ / "sub/sheet.ply");
  ASSERT_EQ(run("render " + path("here/link/../scene.json") +
                " --quiet -m fourier:bands=3 --partial " + path("sums.exr"))
                .exit_code,
            0);
  const Outcome outcome = merge(path("sums.exr"), "-o " + path("merged.exr"));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

TEST_F(UnitMergeSums, TheOrderOfTheFilesDoesNotMatter) {
  const std::string files = draw("weighted-average", "part");
  ASSERT_EQ(merge(files, "-o " + path("a.exr")).exit_code, 0);
  ASSERT_EQ(merge(path("part1.exr") + ' ' + path("part2.exr") + ' ' + path("part3.exr"),
                  "-o " + path("b.exr"))
                .exit_code,
            0);
  EXPECT_EQ(read_text(path("a.exr")), read_text(path("b.exr")));
}

TEST_F(UnitMergeSums, ASecondPhaseDrawnElsewhereIsTheSame) {
  const std::string first = draw("fourier:bands=3", "first");
  ASSERT_EQ(merge(first, "-o " + path("here.exr") + " --partial " + path("totals.exr")).exit_code,
            0);
  const std::string totals = " --totals " + path("totals.exr");
  const std::string second = draw("fourier:bands=3", "second", totals);
  const Outcome outcome = merge(second, "-o " + path("there.exr") + totals);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(read_text(path("here.exr")), read_text(path("there.exr")));
  EXPECT_THAT(refusal("merge " + second + " --quiet -o " + path("m.exr")), HasSubstr("--totals"));
  EXPECT_THAT(refusal("merge " + first + " --quiet -o " + path("m.exr") + totals),
              HasSubstr("--totals: accepted: with -o and sums of phase 2"));
}

TEST_F(UnitMergeSums, WithoutAPartItIsOfTheWhole) {
  const Outcome outcome =
      run("render " + scene().string() + " -m weighted-sum --json --partial " + path("all.exr"));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(nlohmann::json::parse(outcome.out).at("part"), nlohmann::json({1, 1}));
  ASSERT_EQ(merge(path("all.exr"), "-o " + path("merged.exr")).exit_code, 0);
  ASSERT_EQ(run(render("weighted-sum", "whole.exr")).exit_code, 0);
  EXPECT_EQ(image("merged.exr").pixels, image("whole.exr").pixels);
}

TEST_F(UnitMergeSums, WithoutABackgroundItHasNoneEither) {
  const std::string none = " --background none";
  for (const std::string method : {"weighted-blended", "fourier:bands=3"}) {
    const std::string files = draw(method, "part", none);
    for (const std::string ending : {".exr", ".png"}) {
      ASSERT_EQ(run(render(method, "whole" + ending) + none).exit_code, 0);
      ASSERT_EQ(merge(files, "-o " + path("merged" + ending)).exit_code, 0);
    }
    EXPECT_THAT(read_text(path("merged.exr")), HasSubstr("premultiplied by A"));
    EXPECT_LE(testing::largest_difference(image("merged.exr"), image("whole.exr")), 2e-3);
    EXPECT_EQ(image("merged.png").at(0, 0).a, image("whole.png").at(0, 0).a) << method;
    EXPECT_LT(image("merged.png").at(0, 0).a, 1);
  }
}

/// Without --totals it is refused, and the sums are not left behind.
TEST_F(UnitMergeSums, ARefusedMergeLeavesNoSums) {
  const std::string first = draw("fourier:bands=3", "first");
  ASSERT_EQ(merge(first, "--partial " + path("totals.exr")).exit_code, 0);
  const std::string second = draw("fourier:bands=3", "second", "--totals " + path("totals.exr"));
  EXPECT_THAT(refusal("merge " + second + " --quiet -o " + path("m.exr") + " --partial " +
                      path("left.exr")),
              HasSubstr("--totals"));
}

TEST_F(UnitMergeSums, WrongCallsAreRefused) {
  EXPECT_THAT(refusal(render_part("tree", "1/2", "p.exr")),
              AllOf(HasSubstr("--partial: the method is 'tree'"), HasSubstr("weighted-sum")));
  EXPECT_THAT(refusal(render_part("raytrace", "1/2", "p.exr")), HasSubstr("of raytrace --deep"));
  EXPECT_THAT(refusal(render_part("fourier:subset=2", "1/2", "p.exr")), HasSubstr("subset=2"));
  EXPECT_THAT(refusal(render_part("fourier", "1/2", "p.exr", "--samples 2")), HasSubstr("samples"));
  EXPECT_THAT(refusal(render_part("fourier", "1/2", "p.exr", "-o " + path("o.exr"))),
              HasSubstr("--partial"));
  EXPECT_THAT(refusal(render_part("fourier", "3/2", "p.exr")), HasSubstr("--part: '3/2'"));
  EXPECT_THAT(refusal(render("fourier") + " --totals " + path("t.exr")), HasSubstr("--partial"));
  EXPECT_THAT(refusal(render("fourier") + " --part 1/2"), HasSubstr("--part"));
}

TEST_F(UnitMergeSums, WhatAreNotAllSumsOfOnePictureIsRefused) {
  const std::string one = path("1.exr"), two = path("2.exr"),
                    output = " --quiet -o " + path("m.exr");
  ASSERT_EQ(run(render_part("weighted-sum", "1/2", "1.exr")).exit_code, 0);
  EXPECT_THAT(refusal("merge " + one + output), HasSubstr("part 2 of 2 is missing"));
  ASSERT_EQ(run(render_part("weighted-average", "2/2", "2.exr")).exit_code, 0);
  EXPECT_THAT(refusal("merge " + one + ' ' + two + output),
              HasSubstr("2.exr: its method is weighted-average"));
  ASSERT_EQ(run(render_part("weighted-sum", "2/2", "2.exr", "--view +x")).exit_code, 0);
  EXPECT_THAT(refusal("merge " + one + ' ' + two + output), HasSubstr("2.exr: its camera is"));
  ASSERT_EQ(run(render("raytrace", "flat.exr")).exit_code, 0);
  EXPECT_THAT(refusal("merge " + path("flat.exr") + output),
              HasSubstr("flat.exr: does not hold sums"));
  ASSERT_EQ(run(render_part("weighted-sum", "2/2", "2.exr")).exit_code, 0);
  std::filesystem::resize_file(two, std::filesystem::file_size(two) / 2);
  EXPECT_THAT(refusal("merge " + one + ' ' + two + output), HasSubstr("2.exr"));
  EXPECT_FALSE(std::filesystem::exists(path("m.exr")));
}

TEST_F(UnitMergeSums, AChangedSceneHasNoSecondPhase) {
  const std::string files = draw("moment", "part");
  write_text(folder_ / "sheet.ply", read_text(folder_ / "sheet.ply") + " ");
  EXPECT_THAT(refusal("merge " + files + " --quiet -o " + path("m.exr")),
              HasSubstr("scene.json: its content of the scene"));
  std::filesystem::remove(scene());
  EXPECT_THAT(refusal("merge " + files + " --quiet -o " + path("m.exr")), HasSubstr("scene.json"));
}

}  // namespace
}  // namespace pellucid::app
