// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/appearance/color_space.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/options/names.h"

namespace pellucid::scene {
namespace {

const ColorSpace& space(std::string_view name) { return find_row("space", name, color_spaces()); }

double largest_difference(const Vec3& a, const Vec3& b) {
  const Vec3 d = glm::abs(a - b);
  return std::max({d.x, d.y, d.z});
}

TEST(UnitColorSpace, EveryOneBeginsAndEndsWithItsColours) {
  const Vec3 colors[] = {{0, 0, 0}, {1, 1, 1}, {1, 0, 0}, {0.2, 0.4, 0.9}, {0.5, 0.5, 0.5}};
  for (const ColorSpace& s : color_spaces())
    for (const Vec3& a : colors)
      for (const Vec3& b : colors) {
        // The matrix has four digits, its inverse all: what is left are roundings.
        EXPECT_LE(largest_difference(s.between(a, b, 0), a), 1e-9) << s.name;
        EXPECT_LE(largest_difference(s.between(a, b, 1), b), 1e-9) << s.name;
      }
}

TEST(UnitColorSpace, TheMiddleOfBlackAndWhiteIsTheGreyOfHalfTheLightness) {
  // L* = 50 is Y = ((50 + 16) / 116)³ = 0.184187, which sRGB writes 1.055 Y^(1/2.4) - 0.055.
  const double grey = 1.055 * std::pow(std::pow(66.0 / 116, 3), 1 / 2.4) - 0.055;
  EXPECT_NEAR(grey, 119 / 255.0, 0.5 / 255);
  EXPECT_LE(largest_difference(space("Lab").between(Vec3(0), Vec3(1), 0.5), Vec3(grey)), 1e-12);
  EXPECT_EQ(space("RGB").between(Vec3(0), Vec3(1), 0.5), Vec3(0.5));
}

TEST(AgreementColorSpace, MorelandsTableIsDiverging) {
  // His ends of three digits. The table is linear between 33 of his colours, and of 8 bits: it is
  // half of 1/255 off, between two of its entries once more, by its neighbours' roundings.
  const Vec3 cool(0.230, 0.299, 0.754), warm(0.706, 0.016, 0.150);
  const ColormapRow& table = find_colormap("coolwarm");
  for (int i = 0; i <= 32; ++i) {
    const double x = i / 32.0;
    EXPECT_LE(largest_difference(space("Diverging").between(cool, warm, x), table(x)), 1.0 / 255)
        << x;
  }
}

TEST(PropertyColorSpace, StopsInRgbFollowTheSpace) {
  const std::vector<ColorStop> stops{{-1, {0, 0, 0}}, {2, {0.9, 0.9, 0.1}}, {3, {0.1, 0.1, 1}}};
  for (const ColorSpace& s : color_spaces()) {
    const Colormap map(linear_in_rgb(stops, s));
    EXPECT_EQ(map.ends(), Vec2(-1, 3));
    for (double x = 0; x <= 3; x += 0.01) {
      const Vec3 color = s.between(stops[0].color, stops[1].color, x / 3);
      EXPECT_LE(largest_difference(map(x / 4), color), 1.0 / 255) << s.name << ' ' << x;
    }
  }
}

// Colours that sRGB has not lie between many that it has: its channels are cut off there.
TEST(PropertyColorSpace, StopsFollowSharpTurnsToo) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int n = 0; n < 40; ++n) {
    const auto any = [&] {
      const Vec3 color(unit(random), unit(random), unit(random));
      return n % 2 == 0 ? color : glm::round(color);  // a corner of the cube
    };
    const std::vector<ColorStop> stops{{0, any()}, {1, any()}};
    for (const ColorSpace& s : color_spaces()) {
      const Colormap map(linear_in_rgb(stops, s));
      for (double x = 0.0003; x < 1; x += 0.0017) {
        // A quarter of 1/255 is held at a chord's quarters, and most of one between.
        EXPECT_LE(largest_difference(map(x), s.between(stops[0].color, stops[1].color, x)),
                  0.5 / 255)
            << s.name << ' ' << n << ' ' << x;
      }
    }
  }
}

TEST(UnitColorSpace, StopsMayBeNextToEachOtherAsNumbers) {
  const std::vector<ColorStop> stops{{1, {0, 0, 0}}, {std::nextafter(1, 2), {1, 1, 0}}};
  for (const ColorSpace& s : color_spaces())
    EXPECT_EQ(Colormap(linear_in_rgb(stops, s)).ends(), Vec2(1, std::nextafter(1, 2))) << s.name;
}

// What VTK 9.1's vtkColorTransferFunction has in the middle, which ParaView shows.
TEST(AgreementColorSpace, DivergingIsVtks) {
  struct Case {
    Vec3 from, to, middle;
  };
  // The hue of the first pair lies between -π/3, where the paper turns the other way, and -0.3 π.
  const Case cases[] = {{{0.2, 0.2, 0.7}, {0.85, 0.85, 0.85}, {0.63745, 0.64453, 0.99317}},
                        {{0.85, 0.85, 0.85}, {0.2, 0.2, 0.7}, {0.63745, 0.64453, 0.99317}},
                        {{0.2, 0.5, 0.3}, {0.9, 0.9, 0.9}, {0.44516, 0.74909, 0.69896}},
                        {{0.23, 0.3, 0.75}, {0.3, 0.7, 0.3}, {0.91691, 0.91693, 0.91691}},
                        {{0.1, 0.4, 0.7}, {0.5, 0.3, 0.8}, {0.304, 0.38163, 0.7853}}};
  for (const auto& [from, to, middle] : cases)  // whose matrices have other last digits
    EXPECT_LE(largest_difference(space("Diverging").between(from, to, 0.5), middle), 1e-3)
        << from.x << ' ' << from.y;
}

}  // namespace
}  // namespace pellucid::scene
