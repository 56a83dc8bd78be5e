// SPDX-License-Identifier: GPL-3.0-or-later
// Faults of the picture: kept digits, colours, background, turns and shifts.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "compare/pictures/srgb.h"
#include "tests/compare/conform/verdicts.h"

namespace pellucid::compare {
namespace {

using ::testing::HasSubstr;
using testing::UnitVerdict;

TEST_F(UnitVerdict, OfTheRightPictureIsThatItPasses) {
  for (const ConformanceCase& c : conformance_cases()) {
    EXPECT_TRUE(judge(c, expected_picture(c), false).passed) << c.name;
    EXPECT_TRUE(judge(c, displayed_values(expected_picture(c)), true).passed) << c.name;
  }
}

TEST_F(UnitVerdict, NamesAResultOfEightBitsInAFileOfFloats) {
  const ConformanceCase& c = named("layers-10");
  EXPECT_EQ(judge(c, displayed_values(expected_picture(c)), false).fault, Fault::eight_bits);
}

/// Half floats err by as little as 8 bits do, but otherwise.
TEST_F(UnitVerdict, TakesNoHalfFloatsForEightBits) {
  const ConformanceCase& c = named("layers-10");
  Image halves = expected_picture(c);
  for (Rgba& pixel : halves.pixels)
    for (int k = 0; k < 3; ++k) pixel[k] = to_half(pixel[k]);
  const Verdict verdict = judge(c, halves, false, 1e-6);
  EXPECT_FALSE(verdict.passed);
  EXPECT_NE(verdict.fault, Fault::eight_bits);
}

TEST_F(UnitVerdict, NamesAnotherBackground) {
  EXPECT_EQ(verdict("layers-10", as_they_are, Vec3(0)).fault, Fault::background);
  const Verdict white = verdict("lines-wide", as_they_are, Vec3(1));
  EXPECT_EQ(white.fault, Fault::background);
  EXPECT_THAT(white.explanation, HasSubstr("(1, 1, 1) shows through, not (0.1, 0.5, 0.9)"));
}

/// Blending in 8 bits draws nothing of 255 layers of half a step.
TEST_F(UnitVerdict, NamesBlendingInEightBits) {
  const ConformanceCase& c = named("opacity-1-510");
  Image image(c.scene.width, c.scene.height, Rgba(c.scene.background, 1));
  EXPECT_EQ(judge(c, displayed_values(image), false).fault, Fault::eight_bits);
}

TEST_F(UnitVerdict, NamesAPictureThatIsTurned) {
  const ConformanceCase& c = named("points-large");
  Image image = expected_picture(c);
  std::ranges::reverse(image.pixels);
  const Verdict turned = judge(c, image, false);
  EXPECT_EQ(turned.fault, Fault::picture);
  EXPECT_THAT(turned.explanation, HasSubstr("180 degrees"));
}

/// Small errors look right: they are never said to be of another order, or of no change at all.
TEST_F(UnitVerdict, NamesWhatKeepsFewDigits) {
  const auto bytes = [](float x) { return std::round(255 * x) / 255; };
  const auto each = [](const auto& round, bool color) {
    return [=](Layers layers) {
      for (Rgba& l : layers)
        l = color ? Rgba(round(l.r), round(l.g), round(l.b), round(l.a))
                  : Rgba(l.r, l.g, l.b, round(l.a));
      return layers;
    };
  };
  for (const ConformanceCase& c : conformance_cases()) {
    const Verdict half = verdict(c.name, each(to_half, true)),
                  byte = verdict(c.name, each(bytes, true)),
                  alpha = verdict(c.name, each(bytes, false));
    if (!half.passed) {
      EXPECT_EQ(half.fault, Fault::precision) << c.name << ": " << half.explanation;
    }
    if (!byte.passed) {
      EXPECT_EQ(byte.fault, Fault::eight_bits) << c.name << ": " << byte.explanation;
    }
    if (!alpha.passed) {
      EXPECT_EQ(alpha.fault, Fault::eight_bits) << c.name << ": " << alpha.explanation;
    }
  }
}

TEST_F(UnitVerdict, NamesABlackBackgroundInAFileOfEightBits) {
  for (const ConformanceCase& c : conformance_cases()) {
    Image image(c.scene.width, c.scene.height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
      image.pixels[i] = Rgba(composite_of(c.of_pixel(i), Vec3(0)));
    const Verdict black = judge(c, displayed_values(image), true);
    if (!black.passed && black.max_error > 0.02) {
      EXPECT_EQ(black.fault, Fault::background) << c.name << ": " << black.explanation;
    }
  }
}

TEST_F(UnitVerdict, NamesATransferCurve) {
  for (const char* name : {"layers-1", "layers-10", "crossing-3", "points-large"}) {
    const ConformanceCase& c = named(name);
    Image image = expected_picture(c);
    for (Rgba& pixel : image.pixels)
      pixel = Rgba(encoded_as_srgb(pixel.r), encoded_as_srgb(pixel.g), encoded_as_srgb(pixel.b), 1);
    const Verdict curve = judge(c, image, false);
    EXPECT_EQ(curve.fault, Fault::colors) << name << ": " << curve.explanation;
    EXPECT_EQ(curve.explanation, "encoded as sRGB");
  }
}

/// In every case, whatever its layers; what is not seen passes.
void expect_everywhere(std::string_view fault,
                       const std::function<Image(const ConformanceCase&)>& drawn) {
  for (const ConformanceCase& c : conformance_cases()) {
    const Verdict verdict = judge(c, drawn(c), false);
    if (!verdict.passed) {
      EXPECT_EQ(verdict.fault, fault) << c.name << ": " << verdict.explanation;
    }
  }
}

template <class Change>
Image changed(const ConformanceCase& c, const Change& change) {
  Image image = expected_picture(c);
  for (Rgba& pixel : image.pixels) pixel = change(pixel);
  return image;
}

/// One layer's picture has but one colour to tell a background by: that it is grey bears it out.
TEST_F(UnitVerdict, NamesAGreyBackground) {
  expect_everywhere(Fault::background, [](const ConformanceCase& c) {
    Image image(c.scene.width, c.scene.height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
      image.pixels[i] = Rgba(composite_of(c.of_pixel(i), Vec3(0.5)));
    return image;
  });
}

/// A background has to differ from the scene's own to be another one.
TEST_F(UnitVerdict, NamesTheRoundingOfHalfFloats) {
  expect_everywhere(Fault::precision, [](const ConformanceCase& c) {
    return changed(c, [](Rgba p) {
      for (int k = 0; k < 3; ++k) p[k] = to_half(p[k]);
      return p;
    });
  });
}

TEST_F(UnitVerdict, NamesWrongColours) {
  const std::function<Rgba(Rgba)> wrong[] = {
      [](Rgba p) { return Rgba(255.f * glm::vec3(p), p.a); },
      [](Rgba p) { return Rgba(1.1f * glm::vec3(p), p.a); },
      [](Rgba p) { return Rgba(p.b, p.g, p.r, p.a); },
      [](Rgba p) { return Rgba(glm::pow(glm::vec3(p), glm::vec3(1 / 2.2f)), p.a); },
      [](Rgba p) { return Rgba(glm::pow(glm::vec3(p), glm::vec3(2.2f)), p.a); }};
  for (const auto& change : wrong)
    expect_everywhere(Fault::colors, [&](const ConformanceCase& c) { return changed(c, change); });
  const auto is = [](const auto& change, const char* text) {
    const ConformanceCase c = conformance_cases().front();
    EXPECT_EQ(judge(c, changed(c, change), false).explanation, text);
  };
  is(wrong[0], "values of 0 to 255 in the place of 0 to 1");
  is(wrong[1], "values are multiplied by 1.1");
  is(wrong[2], "channels are exchanged: BGR for RGB");
  is(wrong[3], "values are raised to a power of 1/2.2");
  is(wrong[4], "values are raised to a power of 2.2");
}

/// As a window with an alpha channel that is blended into another one.
TEST_F(UnitVerdict, NamesAPictureBlendedAgain) {
  for (const ConformanceCase& c : conformance_cases()) {
    Image image(c.scene.width, c.scene.height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
      double transmittance = 1;
      for (const Rgba& layer : c.of_pixel(i)) transmittance *= 1 - double(layer.a);
      const Vec3 once(composite_of(c.of_pixel(i), c.scene.background));
      image.pixels[i] = Rgba((1 - transmittance) * once + transmittance * c.scene.background, 1);
    }
    const Verdict again = judge(c, image, false);
    if (!again.passed) {
      EXPECT_EQ(again.fault, Fault::colors) << c.name << ": " << again.explanation;
    }
    if (c.name == "layers-10" || c.name == "crossing-2" || c.name == "points-large") {
      EXPECT_EQ(again.explanation, "the picture is blended over its background twice") << c.name;
    }
  }
}

TEST_F(UnitVerdict, NamesAShiftByWholePixels) {
  const ConformanceCase& c = named("points-small");
  const Image right = expected_picture(c);
  Image moved = right;
  for (int y = 0; y < right.height; ++y)
    for (int x = 1; x < right.width; ++x) moved.at(x, y) = right.at(x - 1, y);
  EXPECT_EQ(judge(c, moved, false).explanation, "shifted by 1 pixels to the right and 0 down");
}

}  // namespace
}  // namespace pellucid::compare
