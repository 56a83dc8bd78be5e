// SPDX-License-Identifier: GPL-3.0-or-later
// The files of a figure, as other programs read them.
#include <gmock/gmock.h>

#include <cstdlib>

#include "compare/figure/sheet_drawing.h"
#include "compare/figure/write_figure.h"
#include "compare/pictures/image_file.h"
#include "core/error.h"
#include "core/files/output_file.h"
#include "tests/compare/figure/figure_runs.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using testing::FigureRun;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* hostile = "50% of <b>&\"x_1$^~ \\input{a}";
const Crop crop{12, 4, 16, 8};

class UnitFigureFiles : public ::testing::Test {
 protected:
  fs::path draw(const std::string& name, const FigureStyle& style = {}) {
    write_figure(run_.file(name), run_.run(), request_, style, "pellucid figure\n\\input{b}");
    return run_.file(name);
  }

  /// What a program prints.
  std::string printed(const std::string& command) {
    const fs::path file = run_.file("printed");
    const int status = std::system((command + " >" + file.string() + " 2>&1").c_str());
    EXPECT_EQ(status, 0) << command << ": " << read_text(file);
    return read_text(file);
  }

  static bool has(const std::string& program) {
    return std::system(("command -v " + program + " >/dev/null").c_str()) == 0;
  }

  void SetUp() override {
    request_.scenes = {"a"};
    request_.crops = {{"", crop}};
    request_.labels = {hostile, "Größe", "C\xff\x01"};
  }

  FigureRun run_;
  FigureRequest request_;
};

/// Whether the picture is the crop of the row's EXR, in the 256 values of a screen.
void expect_crop(const Image& picture, const fs::path& exr) {
  const Image whole = read_image(exr);
  ASSERT_EQ(picture.width, crop.width);
  ASSERT_EQ(picture.height, crop.height);
  for (int y = 0; y < crop.height; ++y)
    for (int x = 0; x < crop.width; ++x)
      for (int c = 0; c < 3; ++c)
        ASSERT_EQ(displayed_byte(picture.at(x, y)[c]),
                  displayed_byte(whole.at(crop.x + x, crop.y + y)[c]))
            << x << ", " << y;
}

TEST_F(UnitFigureFiles, APdfHoldsItsTextsAsTextInEmbeddedFonts) {
  if (!has("pdftotext")) GTEST_SKIP() << "poppler-utils is missing";
  const std::string pdf = draw("f.pdf").string();
  const std::string text = printed("pdftotext -layout " + pdf + " -");
  EXPECT_THAT(text, AllOf(HasSubstr(hostile), HasSubstr("Größe"), HasSubstr("300.0 ms"),
                          HasSubstr("RMSE 0.250"), HasSubstr("reference")));
  const std::string fonts = printed("pdffonts " + pdf);
  EXPECT_THAT(fonts, HasSubstr(" yes "));
  EXPECT_THAT(fonts, Not(HasSubstr(" no  ")));  // the column of what is embedded comes first
  EXPECT_THAT(printed("pdfinfo " + pdf), AllOf(HasSubstr("study. From left"), HasSubstr("515.")));
}

TEST_F(UnitFigureFiles, APdfHoldsTheCropsPixelsAsTheyAre) {
  if (!has("pdfimages")) GTEST_SKIP() << "poppler-utils is missing";
  const std::string pdf = draw("f.pdf").string();
  printed("pdfimages -png " + pdf + " " + run_.file("image").string());
  // Of each column the picture, then its crop.
  expect_crop(read_image(run_.file("image-001.png")), run_.picture(0));
  expect_crop(read_image(run_.file("image-003.png")), run_.picture(1));
  expect_crop(read_image(run_.file("image-005.png")), run_.picture(2));
  EXPECT_EQ(read_image(run_.file("image-004.png")).width, 40);
}

TEST_F(UnitFigureFiles, EqualFiguresAreEqualFiles) {
  for (const char* ending : {".pdf", ".png", ".tex"}) {  // SVG: in a process of its own
    const std::string first = read_text(draw(std::string("f") + ending));
    EXPECT_TRUE(first == read_text(draw(std::string("f") + ending))) << ending;
    EXPECT_THAT(first, Not(HasSubstr("CreationDate (D:2"))) << ending;
  }
}

TEST_F(UnitFigureFiles, ASvgIsWellFormed) {
  if (!has("python3")) GTEST_SKIP() << "python3 is missing";
  const std::string svg = draw("f.svg").string();
  EXPECT_EQ(printed("python3 -c 'import sys, xml.dom.minidom as m\n"
                    "print(m.parse(sys.argv[1]).documentElement.tagName)' " +
                    svg),
            "svg\n");
}

TEST_F(UnitFigureFiles, APngHasItsDotsAndPixelsWithHardEdges) {
  FigureStyle style;
  style.width = width_of_text("88.9");
  style.dots_per_inch = 254;  // 10 dots a millimetre
  const Image picture = read_image(draw("f.png", style));
  EXPECT_EQ(picture.width, 889);
  // An inset is 82 points wide, 16 pixels: its middle row begins half way down.
  const Image exr = read_image(run_.picture(2));
  const double dots = 254 / 72.0, width = (252 - 2 - 6) / 3.0, inset = width / crop.width * dots;
  const double left = (1 + 2 * (width + 3)) * dots;
  const double bottom = picture.height;
  int found = 0;
  for (int y = 0; y < int(bottom); ++y) {
    bool all = true;
    for (int x = 1; x + 1 < crop.width && all; ++x) {
      const Rgba& dot = picture.at(int(left + (x + 0.5) * inset), y);
      for (int c = 0; c < 3; ++c)
        all = all && displayed_byte(dot[c]) == displayed_byte(exr.at(crop.x + x, crop.y + 3)[c]);
    }
    found += all;
  }
  EXPECT_NEAR(found, inset, 1.5);  // a row of pixels is as high as one is wide
}

TEST_F(UnitFigureFiles, LatexIsEscaped) {
  const std::string text = read_text(draw("f.tex"));
  EXPECT_THAT(
      text,
      HasSubstr(R"(50\% of \textless{}b\textgreater{}\&"x\_1\$\textasciicircum{}\textasciitilde{} )"
                R"(\textbackslash{}input\{a\})"));
  EXPECT_THAT(text, AllOf(HasSubstr(R"(\includegraphics[width=515.62\unitlength]{f-pictures.pdf})"),
                          HasSubstr(R"(\textbf{0.9900})"), HasSubstr(R"(\begin{figure*}[t])")));
  EXPECT_THAT(
      text, AllOf(Not(HasSubstr("\n\\input")), Not(HasSubstr("\\input{a")), Not(HasSubstr("50%"))));
  EXPECT_TRUE(fs::exists(run_.file("f-pictures.pdf")));
  if (!has("pdftotext")) GTEST_SKIP() << "poppler-utils is missing";
  EXPECT_THAT(printed("pdftotext " + run_.file("f-pictures.pdf").string() + " -"),
              Not(HasSubstr("RMSE")));
}

TEST_F(UnitFigureFiles, OtherEndingsAndNamesAreRefused) {
  EXPECT_THROW(draw("f.eps"), InputError);
  EXPECT_THROW(draw("f"), InputError);
  EXPECT_THROW(draw("a b.tex"), InputError);
  EXPECT_NO_THROW(draw("a b.svg"));
  // A label ends where its '%' begins a comment.
  EXPECT_THROW(write_figure_table(run_.file("50%.tex"), run_.run(), {}, {}, "command"), InputError);
  EXPECT_THROW(width_of_text("ieeee"), InputError);
  EXPECT_THROW(width_of_text("19"), InputError);
  EXPECT_THROW(width_of_text("nan"), InputError);
  EXPECT_TRUE(width_of_text("120").is_page);
}

TEST(UnitTextRuler, BoldIsWiderAndRaisedNarrower) {
  const TextRuler width = text_ruler("sans-serif");
  EXPECT_GT(width({{"12345", true}}, 8), width({{"12345"}}, 8));
  EXPECT_LT(width({{"12345", false, true}}, 8), width({{"12345"}}, 8));
  EXPECT_NEAR(width({{"12345"}}, 16), 2 * width({{"12345"}}, 8), 0.01);
  EXPECT_GT(width({{"<b>"}}, 8), width({{"b"}}, 8));  // no mark-up
}

}  // namespace
}  // namespace pellucid::compare
