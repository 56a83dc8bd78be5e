// SPDX-License-Identifier: GPL-3.0-or-later
// The keys of colours, colour maps and transforms in a scene file.

#include <gmock/gmock.h>

#include "core/files/output_file.h"
#include "scene/appearance/colormap.h"
#include "tests/scene/files/scene_file_folder.h"

namespace pellucid::scene {
namespace {

using ::testing::HasSubstr;

/// The sheet's scalar "speed" is 0, 1, 2, 4 at its vertices.
class UnitAppearanceFile : public testing::SceneFileTest {
 protected:
  Vec3 color(const std::string& of_color, std::size_t vertex) const {
    const Scene scene = with(R"({"mesh": "sheet.ply", "color": )" + of_color + "}");
    return Vec3(scene.objects[0].vertices().colors[vertex]);
  }
  std::string wrong_color(const std::string& of_color) const {
    return refusal(R"({"mesh": "sheet.ply", "color": )" + of_color + "}");
  }
  std::string by(const std::string& keys) const { return R"({"by": "speed", )" + keys + "}"; }
};

// Colours are floats: n/255 rounds by 2^-25.
void expect_near(const Vec3& a, const Vec3& b) { EXPECT_LE(glm::length(a - b), 1e-7); }

TEST_F(UnitAppearanceFile, ColoursAreNumbersDigitsOrNames) {
  expect_near(color("[1, 0.5, 0]", 0), {1, 0.5, 0});
  expect_near(color("\"#ff0080\"", 0), Vec3(255, 0, 128) / 255.0);
  expect_near(color("\"steelblue\"", 0), Vec3(70, 130, 180) / 255.0);
  EXPECT_EQ(with(sheet, R"("background": "black")").background, Vec3(0));
  EXPECT_THAT(wrong_color("\"stealblue\""), HasSubstr("objects[0].color: unknown colour "
                                                      "'stealblue'; known: steelblue"));
  EXPECT_THAT(refusal(sheet, R"("background": "#ffffff80")"),
              HasSubstr("background: '#ffffff80' has an opacity"));
  EXPECT_THAT(refusal(sheet, R"("background": "#12")"), HasSubstr("background: '#12'; accepted"));
}

TEST_F(UnitAppearanceFile, TheOpacityOfAColourIsTheObjects) {
  const auto alpha = [&](const std::string& keys) {
    return with(R"({"mesh": "sheet.ply", )" + keys + "}").objects[0].vertices().colors[0].a;
  };
  EXPECT_EQ(alpha(R"("color": "#ff008033")"), 0.2f);
  EXPECT_EQ(alpha(R"("color": "#ff0080")"), 0.125f);  // the mesh's own
  EXPECT_EQ(alpha(R"("color": "red", "opacity": 0.5)"), 0.5f);
  EXPECT_THAT(refusal(R"({"mesh": "sheet.ply", "color": "#ff008033", "opacity": 0.5})"),
              HasSubstr("objects[0].color: has an opacity, too; accepted: one of both"));
}

TEST_F(UnitAppearanceFile, AMapMayBeAListOfStops) {
  const std::string stops = R"("map": [[0, "red"], [0.25, [0, 1, 0]], [1, "#0000ff"]])";
  expect_near(color(by(stops), 0), {1, 0, 0});
  expect_near(color(by(stops), 1), {0, 1, 0});
  expect_near(color(by(stops), 3), {0, 0, 1});
  // Colours alone are at even distances; of the range 0 … 4, 1 is half way between the first two.
  expect_near(color(by(R"("map": ["red", "lime", "blue"])"), 1), {0.5, 0.5, 0});
  // Beyond 0 … 1 places are values.
  const std::string values = R"("map": [[1, "red"], [2, "blue"]])";
  expect_near(color(by(values), 0), {1, 0, 0});
  expect_near(color(by(values), 2), {0, 0, 1});
  expect_near(color(by(R"("range": [0, 4], )" + values), 2), {0.5, 0, 0.5});
  EXPECT_THAT(wrong_color(by(R"("map": [[0, "red"], [0, "blue"]])")), HasSubstr("ascend"));
  EXPECT_THAT(wrong_color(by(R"("map": ["red"])")), HasSubstr("two stops or more"));
}

TEST_F(UnitAppearanceFile, StopsOfAnotherRangeThanTheUnitAreValues) {
  // 0 … 1 would make the speed of 1 a quarter; 0 … 2 makes it the middle.
  expect_near(color(by(R"("map": [[0, "red"], [2, "blue"]])"), 1), {0.5, 0, 0.5});
  expect_near(color(by(R"("map": [[0.5, "red"], [1, "blue"]])"), 1), {0, 0, 1});
  expect_near(color(by(R"("map": [[0, "red"], [1, "blue"]])"), 1), {0.75, 0, 0.25});
}

TEST_F(UnitAppearanceFile, AMapMayBeParaViews) {
  const std::string map = R"([{"ColorSpace": "RGB", "Name": "mine",
    "NanColor": [1, 1, 0], "RGBPoints": [-1, 1, 0, 0, 0, 0, 1, 0, 3, 0, 0, 1]}])";
  write_text(folder_ / "map.json", map);
  // Its places are values: -1 … 3, of which 0 is green and 4 beyond.
  for (const std::string& given :
       {std::string("\"map.json\""), map, map.substr(1, map.size() - 2)}) {
    expect_near(color(by("\"map\": " + given), 0), {0, 1, 0});
    expect_near(color(by("\"map\": " + given), 3), {0, 0, 1});
  }
  write_text(folder_ / "hsl.json",
             R"([{"ColorSpace": "HSL", "RGBPoints": [0, 1, 0, 0, 1, 0, 0, 1]}])");
  EXPECT_THAT(wrong_color(by(R"("map": "hsl.json")")),
              HasSubstr("[0].ColorSpace: unknown colour space 'HSL'; known: RGB, Lab, Diverging"));
  // In Lab the middle of black and white is the grey of half the lightness, 119 of 255.
  const std::string lab = R"({"ColorSpace": "Lab", "RGBPoints": [0, 0, 0, 0, 2, 1, 1, 1]})";
  EXPECT_LE(glm::length(color(by("\"map\": " + lab), 1) - Vec3(119 / 255.0)), 1.0 / 255);
  write_text(folder_ / "odd.json", R"([{"RGBPoints": [0, 1, 0]}])");
  EXPECT_THAT(wrong_color(by(R"("map": "odd.json")")), HasSubstr("four numbers a stop"));
  EXPECT_THAT(wrong_color(by(R"("map": [])")), HasSubstr("two stops or more"));
  EXPECT_THAT(wrong_color(by(R"("map": "none.json")")), HasSubstr("none.json"));
}

TEST_F(UnitAppearanceFile, AMapOfParaViewsMayBeLogarithmic) {
  const auto map = [&](const std::string& points, const std::string& more = "") {
    return by(R"("map": {"UseLogScale": 1, "RGBPoints": )" + points + "}" + more);
  };
  // Of 1 to 16 by factors, 4 is the middle, and 2 half way there.
  const std::string values = "[1, 0, 0, 0, 4, 1, 1, 1, 16, 1, 0, 0]";
  expect_near(color(map(values), 1), {0, 0, 0});
  expect_near(color(map(values), 2), Vec3(0.5));
  expect_near(color(map(values), 3), {1, 1, 1});
  // Fractions are of the range, 1 to 4: as with the scale that the scene file has.
  const std::string fractions = "[0, 0, 0, 0, 1, 1, 1, 1]";
  expect_near(color(map(fractions), 2), Vec3(0.5));
  expect_near(color(map(fractions, R"(, "scale": "logarithmic")"), 2), Vec3(0.5));
  expect_near(color(by(R"("map": {"UseLogScale": false, "RGBPoints": )" + fractions + "}"), 2),
              Vec3(0.5));
  EXPECT_THAT(
      wrong_color(map("[-1, 0, 0, 0, 4, 1, 1, 1]")),
      HasSubstr("RGBPoints: values from -1 to 4; accepted on a logarithmic scale: ascending "
                "values above 0"));
  EXPECT_THAT(wrong_color(map(values, R"(, "scale": "linear")")),
              HasSubstr("color.scale: its map is by UseLogScale; accepted: logarithmic"));
}

TEST_F(UnitAppearanceFile, StopsThatAreValuesLieByLogarithmsOnALogarithmicScale) {
  const std::string scale = R"("scale": "logarithmic", )";
  // By factors from 0.25 over 1 to 16: 2 is a quarter of the way from the middle stop, 4 a half.
  for (const std::string map :
       {R"([[0.25, "black"], [1, "lime"], [16, "white"]])",
        R"({"RGBPoints": [0.25, 0, 0, 0, 1, 0, 1, 0, 16, 1, 1, 1]})",
        R"({"UseLogScale": 1, "RGBPoints": [0.25, 0, 0, 0, 1, 0, 1, 0, 16, 1, 1, 1]})"}) {
    expect_near(color(by(scale + R"("map": )" + map), 1), {0, 1, 0});
    expect_near(color(by(scale + R"("map": )" + map), 2), {0.25, 1, 0.25});
    expect_near(color(by(scale + R"("map": )" + map), 3), {0.5, 1, 0.5});
  }
  // Fractions are of the range, here 1 to 16, as they stand.
  expect_near(color(by(scale + R"("range": [1, 16], "map": [[0, "black"], [1, "white"]])"), 3),
              Vec3(0.5));
  EXPECT_THAT(wrong_color(by(scale + R"("map": [[0, "black"], [4, "white"]])")),
              HasSubstr("color.map: values from 0 to 4; accepted on a logarithmic scale"));
  EXPECT_THAT(wrong_color(by(scale + R"("map": [[1, "black"], [-1, "red"], [4, "white"]])")),
              HasSubstr("ascending values above 0"));
}

TEST_F(UnitAppearanceFile, RangesMayBePercentilesAndScalesLogarithmic) {
  const ColormapRow& viridis = find_colormap("viridis");
  // Between the quartiles of 0, 1, 2, 4: 0.75 and 2.5.
  expect_near(color(by(R"("range": ["25%", "75%"])"), 1), viridis(0.25 / 1.75));
  expect_near(color(by(R"("range": [0, "75%"])"), 1), viridis(0.4));
  // Of 1, 2, 4 by factors, 2 is the middle; 0 has no logarithm and the colour of the smaller end.
  expect_near(color(by(R"("scale": "logarithmic")"), 2), viridis(0.5));
  expect_near(color(by(R"("scale": "logarithmic")"), 0), viridis(0));
  expect_near(color(by(R"("scale": "logarithmic", "range": [4, 1])"), 0), viridis(1));
  EXPECT_THAT(wrong_color(by(R"("scale": "logarithmic", "range": [0, 1])")),
              HasSubstr("color.range[0]: accepted on a logarithmic scale"));
  for (const char* wrong : {"101%", "-1%", "2", "two%", "nan%", "", "%", "2%%"})
    EXPECT_THAT(wrong_color(by(R"("range": [")" + std::string(wrong) + R"(", 1])")),
                HasSubstr("color.range[0]: '" + std::string(wrong) + "'; accepted: a number, or"));
  EXPECT_THAT(wrong_color(by(R"("range": [1])")), HasSubstr("two numbers or percentiles"));
}

TEST_F(UnitAppearanceFile, TransformsMoveWhatTheyAreGivenTo) {
  const std::string turned = R"("transform": {"scale": 2, "rotate": {"axis": [0, 0, 1],
                             "degrees": 90}, "translate": [0, 0, 3]})";
  const Scene own = with(sheet), scene = with(R"({"mesh": "sheet.ply", )" + turned + "}");
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3 x = own.objects[0].vertices().positions[i];
    EXPECT_EQ(scene.objects[0].vertices().positions[i], Vec3(-2 * x.y, 2 * x.x, 2 * x.z + 3));
  }
  EXPECT_THAT(refusal(R"({"mesh": "sheet.ply", "transform": {"scale": [1, 0, 1]}})"),
              HasSubstr("objects[0].transform.scale: 0; accepted"));
  EXPECT_THAT(refusal(R"({"mesh": "sheet.ply", "transform": {"turn": 1}})"), HasSubstr("turn"));
  EXPECT_THAT(refusal(R"({"isosurface": {"dataset": "sphere-levels", "scalar": "q", "value": 0.1},
                          "transform": {"scale": 2}})"),
              HasSubstr("objects[0].transform: an isosurface has none"));
}

}  // namespace
}  // namespace pellucid::scene
