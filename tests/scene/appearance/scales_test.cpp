// SPDX-License-Identifier: GPL-3.0-or-later
// Percentiles, logarithmic scales, colour maps of one's own, scalars of faces, colours as texts.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "core/error.h"
#include "scene/appearance/appearance.h"
#include "scene/appearance/color_text.h"
#include "scene/appearance/colormap.h"
#include "scene/appearance/face_scalars.h"

namespace pellucid::scene {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

TEST(UnitPercentiles, AreLinearBetweenNeighboursInOrder) {
  // numpy.percentile([40, 0, 30, 10, 20], [0, 12.5, 25, 75, 90, 100]) is 0, 5, 10, 30, 36, 40.
  const std::vector<double> values{40, 0, nan, 30, 10, inf, 20};
  const std::pair<double, double> known[] = {{0, 0},   {12.5, 5}, {25, 10},
                                             {75, 30}, {90, 36},  {100, 40}};
  for (const auto& [percentile, value] : known)
    EXPECT_DOUBLE_EQ(percentile_of(values, percentile), value);
  EXPECT_EQ(percentile_of({7}, 2), 7);
  EXPECT_TRUE(std::isnan(percentile_of({nan, inf}, 50)));
}

TEST(UnitPercentiles, MayBeEitherEndOfARange) {
  ScalarColor by{"s", "viridis", Vec2(25, 100)};
  const std::vector<double> values{-1, 0, 10, 20, 30, 40};
  EXPECT_EQ(range_over(by, values), Vec2(25, 100));
  by.in_percent = {true, false};
  EXPECT_EQ(range_over(by, values), Vec2(2.5, 100));  // numpy.percentile(values, 25)
  by.in_percent = {true, true};
  EXPECT_EQ(range_over(by, values), Vec2(2.5, 40));
  by.scale = Scale::logarithmic;  // of 10, 20, 30, 40
  EXPECT_EQ(range_over(by, values), Vec2(17.5, 40));
}

TEST(PropertyPercentiles, AreThoseOfTheSortedValues) {
  std::mt19937 random(20);
  std::normal_distribution<double> normal;
  for (const std::size_t count : {1u, 2u, 3u, 100u, 1001u}) {
    std::vector<double> values(count);
    for (double& value : values) value = normal(random);
    std::vector<double> sorted = values;
    std::ranges::sort(sorted);
    for (double p = 0; p <= 100; p += 0.7) {
      const double place = p / 100 * double(count - 1);
      const auto below = std::size_t(place);
      const double expected = std::lerp(sorted[below], sorted[std::min(below + 1, count - 1)],
                                        place - std::floor(place));
      EXPECT_DOUBLE_EQ(percentile_of(values, p), expected);
    }
  }
}

TEST(UnitLogarithmicScale, DividesARangeByFactors) {
  const Vec2 range(1, 10000);
  EXPECT_EQ(fraction_of(1, range, Scale::logarithmic), 0);
  EXPECT_DOUBLE_EQ(fraction_of(100, range, Scale::logarithmic), 0.5);
  EXPECT_DOUBLE_EQ(fraction_of(100, {10000, 1}, Scale::logarithmic), 0.5);
  EXPECT_EQ(fraction_of(10000, range, Scale::logarithmic), 1);
  // What has no logarithm lies before the smaller end; what is no number stays none.
  EXPECT_EQ(fraction_of(0, range, Scale::logarithmic), -inf);
  EXPECT_EQ(fraction_of(0, {10000, 1}, Scale::logarithmic), inf);
  EXPECT_EQ(fraction_of(-5, range, Scale::logarithmic), -inf);
  EXPECT_TRUE(std::isnan(fraction_of(nan, range, Scale::logarithmic)));
}

/// It is the limit of one that shrinks: values above it have its high end, itself its low end.
TEST(UnitRanges, OfNoWidthTellAboveFromBelow) {
  for (const Scale scale : {Scale::linear, Scale::logarithmic}) {
    EXPECT_EQ(fraction_of(1, {2, 2}, scale), -inf);
    EXPECT_EQ(fraction_of(2, {2, 2}, scale), 0);
    EXPECT_EQ(fraction_of(3, {2, 2}, scale), inf);
  }
  geometry::Vertices vertices;
  vertices.positions.resize(5);
  vertices.scalars["s"] = {0, 0, 0, 0, 5};
  ScalarColor by{"s", "viridis", Vec2(2, 60)};
  by.in_percent = {true, true};  // 0 … 0
  ScalarOpacity fade{"s", {0.25, 0.75}, Vec2(2, 60)};
  fade.in_percent = {true, true};
  apply_appearance({by, fade, {}}, vertices);
  const auto& map = find_colormap("viridis");
  EXPECT_EQ(vertices.colors[0], Rgba(map(0), 0.25));
  EXPECT_EQ(vertices.colors[4], Rgba(map(1), 0.75));
}

TEST(UnitRanges, MayBeWiderThanANumber) {
  const Vec2 wide(-1.7e308, 1.7e308);
  EXPECT_EQ(fraction_of(0, wide), 0.5);
  EXPECT_EQ(fraction_of(1.7e308, wide), 1);
  EXPECT_EQ(fraction_of(-1.7e308, wide), 0);
  EXPECT_DOUBLE_EQ(fraction_of(0.85e308, wide), 0.75);
  EXPECT_EQ(fraction_of(0, {1.7e308, -1.7e308}), 0.5);
  EXPECT_EQ(fraction_of(inf, wide), inf);
  const Colormap map({{-1.7e308, Vec3(0)}, {1.7e308, Vec3(1)}});
  EXPECT_EQ(map(0.5), Vec3(0.5));
}

TEST(UnitLogarithmicScale, TakesItsRangeFromValuesAboveZero) {
  ScalarColor by{"s", "viridis", {}};
  by.scale = Scale::logarithmic;
  EXPECT_EQ(range_over(by, {-3, 0, 0.1, 50, nan}), Vec2(0.1, 50));
  EXPECT_THROW(range_over(by, {-3, 0}), InputError);
  by.range = Vec2(0, 1);
  EXPECT_THROW(range_over(by, {1, 2}), InputError);
}

TEST(UnitLogarithmicScale, FadesByFactors) {
  geometry::Vertices vertices;
  vertices.positions.resize(3);
  vertices.scalars["s"] = {1, 10, 100};
  ScalarOpacity by{"s", {0.25, 0.75}, {}};
  by.scale = Scale::logarithmic;
  apply_appearance({{}, by, {}}, vertices);
  EXPECT_EQ(vertices.colors[0].a, 0.25f);
  EXPECT_FLOAT_EQ(vertices.colors[1].a, 0.5f);
  EXPECT_EQ(vertices.colors[2].a, 0.75f);
}

TEST(UnitColormap, OfOnesOwnIsLinearBetweenItsStops) {
  const Colormap map({{-10, {1, 0, 0}}, {0, {0, 1, 0}}, {30, {0, 0, 1}}});
  EXPECT_EQ(map(0), Vec3(1, 0, 0));
  EXPECT_EQ(map(0.125), Vec3(0.5, 0.5, 0));
  EXPECT_EQ(map(0.25), Vec3(0, 1, 0));
  EXPECT_EQ(map(0.625), Vec3(0, 0.5, 0.5));
  EXPECT_EQ(map(1), Vec3(0, 0, 1));
  EXPECT_EQ(map(7), Vec3(0, 0, 1));
  EXPECT_EQ(map(-inf), Vec3(1, 0, 0));
  EXPECT_EQ(map(nan), nan_color);
  const ColorStop zero{0, {}}, none{nan, {}};
  EXPECT_THROW(Colormap(std::vector{zero}), InputError);
  EXPECT_THROW(Colormap(std::vector{zero, zero}), InputError);
  EXPECT_THROW(Colormap(std::vector{zero, none}), InputError);
}

TEST(UnitColormap, NanMayHaveAColourOfItsOwn) {
  geometry::Vertices vertices;
  vertices.positions.resize(2);
  vertices.scalars["s"] = {0, nan};
  ScalarColor by{"s", "viridis", {}};
  by.nan = Vec3(0, 0, 1);
  apply_appearance({by, {}, {}}, vertices);
  EXPECT_EQ(Vec3(vertices.colors[1]), Vec3(0, 0, 1));
  EXPECT_NE(Vec3(vertices.colors[0]), Vec3(0, 0, 1));
}

TEST(UnitColorText, IsHexadecimalOrAName) {
  EXPECT_EQ(color_of_text("#ff0080").rgb, Vec3(255, 0, 128) / 255.0);
  EXPECT_EQ(color_of_text("#F08").rgb, Vec3(255, 0, 136) / 255.0);
  EXPECT_EQ(color_of_text("Tomato").rgb, Vec3(255, 99, 71) / 255.0);
  EXPECT_EQ(color_of_text("darkslategrey").rgb, color_of_text("DarkSlateGray").rgb);
  EXPECT_EQ(color_of_text("rebeccapurple").rgb, color_of_text("#663399").rgb);
  // CSS Color 4, section 6.1: every grey has two names, and dark grey is lighter than grey.
  EXPECT_EQ(color_of_text("grey").rgb, color_of_text("#808080").rgb);
  EXPECT_EQ(color_of_text("gray").rgb, color_of_text("#808080").rgb);
  EXPECT_EQ(color_of_text("silver").rgb, color_of_text("#c0c0c0").rgb);
  EXPECT_EQ(color_of_text("darkgrey").rgb, color_of_text("#a9a9a9").rgb);
  EXPECT_EQ(color_of_text("teal").rgb, color_of_text("#008080").rgb);
  EXPECT_EQ(color_of_text("yellowgreen").rgb, color_of_text("#9acd32").rgb);
  for (const char* name : {"", "dark", "darkslate", "dim", "light", "lightslate", "slate"})
    EXPECT_EQ(color_of_text(name + std::string("grey")).rgb,
              color_of_text(name + std::string("gray")).rgb)
        << name;
  for (const char* wrong :
       {"#12345", "#1234567", "#gggggg", "#", "", "tomatoe", "#-12345", "red ", "#+12", "#0x12"})
    EXPECT_THROW(color_of_text(wrong), InputError) << wrong;
}

TEST(UnitColorText, MayHaveAnOpacity) {
  EXPECT_EQ(color_of_text("#ff008033").rgb, Vec3(255, 0, 128) / 255.0);
  EXPECT_EQ(color_of_text("#ff008033").alpha, 0.2);  // 0x33 of 255
  EXPECT_EQ(color_of_text("#f083").alpha, 0.2);
  EXPECT_EQ(color_of_text("#ff0080ff").alpha, 1);
  EXPECT_FALSE(color_of_text("#ff0080").alpha);
  EXPECT_FALSE(color_of_text("tomato").alpha);
}

/// Two triangles that share an edge, one face flat and one bent up; a number for each.
geometry::TriangleMesh two_faces(double first, double second) {
  geometry::TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 1}};
  mesh.triangles = {{0, 1, 2}, {1, 3, 2}};
  mesh.scalars["height"] = {0, 1, 2, 3};
  mesh.face_scalars["region"] = {first, second};
  return mesh;
}

TEST(UnitFaceScalars, MakeEachFaceOfOneValueAndLightItAsBefore) {
  geometry::TriangleMesh mesh = two_faces(5, 9), smooth = two_faces(5, 9);
  ensure_normals(smooth);
  bring_to_vertices({ScalarColor{"region", "viridis", {}}, {}, {}}, mesh);
  ASSERT_EQ(mesh.positions.size(), 6u);  // the shared edge's ends twice
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t now = mesh.triangles[i][k], before = smooth.triangles[i][k];
      EXPECT_EQ(mesh.scalars.at("region")[now], i == 0 ? 5 : 9);
      EXPECT_EQ(mesh.positions[now], smooth.positions[before]);
      EXPECT_EQ(mesh.normals[now], smooth.normals[before]);
      EXPECT_EQ(mesh.scalars.at("height")[now], smooth.scalars.at("height")[before]);
    }
}

TEST(UnitFaceScalars, AreLeftWhereNobodyAsksOrNothingChanges) {
  geometry::TriangleMesh mesh = two_faces(5, 9);
  bring_to_vertices({ScalarColor{"height", "viridis", {}}, {}, {}}, mesh);
  EXPECT_EQ(mesh.positions.size(), 4u);
  EXPECT_TRUE(mesh.normals.empty());
  mesh = two_faces(5, 5);
  bring_to_vertices({{}, ScalarOpacity{"region", {0, 1}, {}}, {}}, mesh);
  EXPECT_EQ(mesh.positions.size(), 4u);
  EXPECT_EQ(mesh.scalars.at("region"), std::vector<double>(4, 5));
  try {
    bring_to_vertices({{}, {}, "regions"}, mesh);
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "unknown scalar 'regions'; known: region, height");
  }
}

}  // namespace
}  // namespace pellucid::scene
