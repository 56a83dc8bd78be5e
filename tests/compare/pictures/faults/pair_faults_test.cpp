// SPDX-License-Identifier: GPL-3.0-or-later
// What looks wrong with one of two pictures, of which neither is known to be right.
#include "compare/pictures/faults/given_faults.h"

#include <gmock/gmock.h>

#include "tests/compare/pictures/faults/faulty_pictures.h"

namespace pellucid::compare {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Of two pictures, whichever is at fault: what a study says of one against the other.
class PropertyPairFaults : public ::testing::Test {
 protected:
  Image on(const Vec3& background) const { return over(none_, background); }
  Image none_ = without_background(drawn(any_scene(7), "raytrace"), any_scene(7).background);
};

TEST_F(PropertyPairFaults, BackgroundsAreNoStraightColours) {
  const PairFaults white = pair_faults(on(Vec3(1)), none_, true);
  EXPECT_FALSE(white.straight);
  EXPECT_THAT(white.of_test, ElementsAre(HasSubstr("premultiplied")));
  for (const Vec3 color : {Vec3(1), Vec3(0.7)}) {
    const PairFaults other = pair_faults(none_, on(color), true);
    EXPECT_FALSE(other.straight);
    EXPECT_THAT(other.of_test, ElementsAre(HasSubstr("has another background")));
    EXPECT_THAT(other.of_reference, IsEmpty());
  }
  const PairFaults black = pair_faults(on(Vec3(0.7)), none_, true);
  EXPECT_FALSE(black.straight);
  EXPECT_THAT(black.of_test, ElementsAre(HasSubstr("premultiplied")));
}

TEST_F(PropertyPairFaults, StraightColoursAreToldOnEitherSide) {
  const Image png = straight(none_, Vec3(0));
  EXPECT_THAT(pair_faults(none_, png, true).straight, ::testing::Optional(HasSubstr("TEST looks")));
  EXPECT_THAT(pair_faults(png, none_, true).straight,
              ::testing::Optional(HasSubstr("REFERENCE looks")));
}

TEST_F(PropertyPairFaults, BytesAndBrightnessAreToldOnEitherSide) {
  const Image white = on(Vec3(1));
  for (const auto& [factor, text] : {std::pair(255.f, "255 times"), std::pair(0.5f, "half as")}) {
    Image wrong = white;
    for (Rgba& pixel : wrong.pixels) pixel = Rgba(factor * glm::vec3(pixel), pixel.a);
    const PairFaults test = pair_faults(white, wrong, true),
                     reference = pair_faults(wrong, white, true);
    EXPECT_THAT(test.of_test, ElementsAre(HasSubstr(text)));
    EXPECT_THAT(reference.of_reference, ElementsAre(HasSubstr(text)));
    EXPECT_THAT(reference.of_test, IsEmpty());
  }
}

/// A curve is undone either way; REFERENCE is right as long as that explains it.
TEST_F(PropertyPairFaults, WhatEitherMayHaveIsOfTest) {
  const Image blue = on({0.125, 0.25, 0.375});
  for (const double exponent : {2.2, 1 / 2.2}) {
    const PairFaults faults = pair_faults(blue, curved(blue, exponent), true);
    EXPECT_THAT(faults.of_test, ElementsAre(HasSubstr("sRGB")));
    EXPECT_THAT(faults.of_reference, IsEmpty());
  }
}

TEST_F(PropertyPairFaults, NoMethodLooksWrongOnEitherSide) {
  for (const Vec3 background : {Vec3(0), Vec3(1), Vec3(0.9, 0.1, 0.1)}) {
    scene::Scene scene = any_scene(2);
    scene.background = background;
    const Image reference = drawn(scene, "raytrace");
    for (const char* method : {"weighted-sum", "weighted-average", "weighted-blended", "fourier",
                               "binning", "moment", "stochastic"}) {
      const Image picture = drawn(scene, method);
      for (const auto& [a, b] :
           {std::pair(&reference, &picture), std::pair(&picture, &reference)}) {
        const PairFaults faults = pair_faults(*a, *b, true);
        EXPECT_FALSE(faults.straight) << method;
        EXPECT_THAT(faults.of_test, IsEmpty()) << method;
        EXPECT_THAT(faults.of_reference, IsEmpty()) << method;
      }
    }
  }
}

}  // namespace
}  // namespace pellucid::compare
