// SPDX-License-Identifier: GPL-3.0-or-later
// Each fault that a picture from elsewhere may have is found and said; a method's own error is
// none.
#include "compare/pictures/faults/given_faults.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "compare/methods/methods.h"
#include "compare/pictures/faults/picture_shift.h"
#include "compare/pictures/image_file.h"
#include "core/options/names.h"
#include "tests/support/pictures.h"
#include "tests/support/scenes.h"

namespace pellucid::compare {
namespace {

using namespace pellucid::testing;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr int width = 120, height = 90;

/// Not symmetric, a third of it uncovered, edges in all directions.
scene::Scene any_scene(std::uint32_t seed) {
  scene::Scene scene = empty_scene(width, height);
  scene.objects.push_back({"triangles", random_triangles(40, seed, 0.9)});
  scene.objects.push_back({"quarter", rectangle(-0.9, 0.1, 0.2, 0.8, 0.3, {0.9, 0.2, 0.1, 0.7})});
  return scene;
}

Image drawn(const scene::Scene& scene, std::string_view method) {
  return render(find_row("method", method, methods()), scene).image;
}

/// The colours as they were before the background, premultiplied.
Image without_background(Image image, const Vec3& background) {
  for (Rgba& p : image.pixels) p -= Rgba(background, 0) * (1 - p.a);
  return image;
}

Image over(Image image, const Vec3& background) {
  for (Rgba& p : image.pixels) p += Rgba(background, 0) * (1 - p.a);
  return image;
}

Image straight(Image image, const Vec3& background) {
  image = without_background(image, background);
  for (Rgba& p : image.pixels)
    if (p.a > 0) p = Rgba(p.r / p.a, p.g / p.a, p.b / p.a, p.a);
  return image;
}

Image upside_down(const Image& image) {
  Image result = image;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) result.at(x, y) = image.at(x, image.height - 1 - y);
  return result;
}

Image mirrored(const Image& image) {
  Image result = image;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) result.at(x, y) = image.at(image.width - 1 - x, y);
  return result;
}

Image curved(Image image, double exponent) {
  for (Rgba& p : image.pixels)
    for (int c = 0; c < 3; ++c) p[c] = float(std::pow(double(p[c]), exponent));
  return image;
}

Image without_alpha(Image image) {
  for (Rgba& p : image.pixels) p.a = 1;
  return image;
}

class PropertyGivenFaults : public ::testing::TestWithParam<const char*> {
 protected:
  std::vector<std::string> faults(const Image& test) const {
    return given_faults(reference_, test, scene_.background);
  }
  scene::Scene scene_ = any_scene(7);
  Image reference_ = drawn(scene_, "raytrace");
  Image right_ = drawn(scene_, GetParam());
};

TEST_P(PropertyGivenFaults, NothingIsWrongWithARightPicture) {
  EXPECT_THAT(faults(right_), IsEmpty());
  EXPECT_THAT(faults(displayed_values(right_)), IsEmpty());
  EXPECT_THAT(faults(without_alpha(right_)), IsEmpty());
}

TEST_P(PropertyGivenFaults, TurnsAreNamed) {
  EXPECT_THAT(faults(upside_down(right_)), ElementsAre(HasSubstr("upside down")));
  EXPECT_THAT(faults(mirrored(right_)), ElementsAre(HasSubstr("mirrored")));
  EXPECT_THAT(faults(upside_down(mirrored(right_))), ElementsAre(HasSubstr("180 degrees")));
}

TEST_P(PropertyGivenFaults, AlphaAndBackgroundsAreNamed) {
  const Vec3 background = scene_.background;
  EXPECT_THAT(faults(without_background(right_, background)),
              ElementsAre(HasSubstr("premultiplied")));
  EXPECT_THAT(faults(straight(right_, background)), ElementsAre(HasSubstr("straight alpha")));
  const Image other = over(without_background(right_, background), {0.4, 0.4, 0.4});
  EXPECT_THAT(faults(other), ElementsAre(HasSubstr("another background: (0.4, 0.4, 0.4)")));
  EXPECT_THAT(faults(without_alpha(other)), ElementsAre(HasSubstr("another background")));
}

TEST_P(PropertyGivenFaults, BytesTakenForFloatsAreNamed) {
  Image bytes = right_;
  for (Rgba& pixel : bytes.pixels) pixel = Rgba(255.f * glm::vec3(pixel), pixel.a);
  EXPECT_THAT(faults(bytes), ElementsAre(HasSubstr("255 times too bright")));
}

TEST_P(PropertyGivenFaults, HalfBrightnessAndExchangedChannelsAreNamed) {
  Image half = right_, exchanged = right_;
  for (Rgba& pixel : half.pixels) pixel = Rgba(0.5f * glm::vec3(pixel), pixel.a);
  for (Rgba& pixel : exchanged.pixels) std::swap(pixel.r, pixel.b);
  EXPECT_THAT(faults(half), ElementsAre(HasSubstr("half as bright")));
  EXPECT_THAT(faults(exchanged), ElementsAre(HasSubstr("red and blue exchanged")));
  EXPECT_THAT(faults(upside_down(exchanged)),
              ElementsAre(HasSubstr("upside down"), HasSubstr("red and blue exchanged")));
}

TEST_P(PropertyGivenFaults, CurvesAreNamed) {
  // sRGB's curve is nearly a power of 2.2.
  EXPECT_THAT(faults(curved(right_, 1 / 2.2)), ElementsAre(HasSubstr("sRGB-encoded")));
  EXPECT_THAT(faults(curved(right_, 2.2)), ElementsAre(HasSubstr("sRGB-decoded")));
}

TEST_P(PropertyGivenFaults, TwoAtOnceAreBothNamed) {
  EXPECT_THAT(faults(upside_down(without_background(right_, scene_.background))),
              ElementsAre(HasSubstr("upside down"), HasSubstr("premultiplied")));
}

/// The scene is moved beside its pixels, which the picture's own camera does exactly.
TEST_P(PropertyGivenFaults, ShiftsAreNamedByTheirSizeAndDirection) {
  const double pixel = scene_.camera.height / height;
  scene::Scene moved = scene_;
  moved.camera.eye.x -= 0.5 * pixel;
  moved.camera.target.x -= 0.5 * pixel;
  EXPECT_THAT(faults(drawn(moved, GetParam())), ElementsAre(HasSubstr("to the right:")));
  moved.camera.eye.y -= 1.5 * pixel;
  moved.camera.target.y -= 1.5 * pixel;
  const Image image = drawn(moved, GetParam());
  EXPECT_THAT(faults(image), ElementsAre(HasSubstr("to the right and")));
  const auto shift = picture_shift(reference_, image, scene_.background);
  ASSERT_TRUE(shift);
  EXPECT_NEAR(shift->x, 0.5, 4 * shift->uncertainty);
  EXPECT_NEAR(shift->y, -1.5, 4 * shift->uncertainty);
}

INSTANTIATE_TEST_SUITE_P(Methods, PropertyGivenFaults,
                         ::testing::Values("raytrace", "weighted-average", "weighted-blended"));

/// No method's error is taken for a fault of the picture, nor that of one pixel.
TEST(PropertyGivenFaultsOfMethods, NoMethodLooksWrong) {
  for (const std::uint32_t seed : {1u, 2u, 3u}) {
    const scene::Scene scene = any_scene(seed);
    const Image reference = drawn(scene, "raytrace");
    for (const char* method : {"weighted-sum", "weighted-average", "weighted-blended", "fourier",
                               "binning", "moment", "stochastic"})
      EXPECT_THAT(given_faults(reference, drawn(scene, method), scene.background), IsEmpty())
          << method << ", " << seed;
  }
}

/// Sheets whose opacity falls to 0 at one side: what is to be seen of them ends where a method has
/// it.
scene::Scene fading_scene() {
  scene::Scene scene = empty_scene(width, height);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(0, 1);
  for (int i = 0; i < 12; ++i) {
    const double x = -1.2 + 0.8 * any(random), y = -0.9 + 0.8 * any(random);
    geometry::TriangleMesh mesh = rectangle(x, x + 1.3, y, y + 0.9, any(random), {});
    const Vec3 color(any(random), any(random), any(random));
    for (std::size_t k = 0; k < 4; ++k)
      mesh.colors[k] = Rgba(color, k == 0 || k == 3 ? 0.1 + 0.5 * any(random) : 0);
    scene.objects.push_back({"sheet", std::move(mesh)});
  }
  return scene;
}

TEST(PropertyGivenFaultsOfMethods, NoMethodLooksWrongWhereLayersFade) {
  const scene::Scene scene = fading_scene();
  const Image reference = drawn(scene, "raytrace");
  for (const char* method : {"weighted-sum", "weighted-average", "weighted-blended", "fourier",
                             "binning", "bin-average", "moment", "tree"}) {
    const Image picture = drawn(scene, method);
    EXPECT_THAT(given_faults(reference, picture, scene.background), IsEmpty()) << method;
    EXPECT_THAT(given_faults(reference, displayed_values(picture), scene.background), IsEmpty())
        << method;
  }
}

TEST(PropertyPictureShift, AnEmptyPictureIsNotShifted) {
  const scene::Scene scene = any_scene(7);
  const Image nothing(width, height, Rgba(scene.background, 0));
  EXPECT_THAT(given_faults(drawn(scene, "raytrace"), nothing, scene.background), IsEmpty());
}

/// The same scene, moved by so many pixels to the right and down.
Image moved(scene::Scene scene, double right, double down) {
  const double pixel = scene.camera.height / height;
  scene.camera.eye += Vec3(-right * pixel, down * pixel, 0);
  scene.camera.target += Vec3(-right * pixel, down * pixel, 0);
  return drawn(scene, "raytrace");
}

void expect_shift(const scene::Scene& scene, double right, double down, double tolerance) {
  const auto shift =
      picture_shift(drawn(scene, "raytrace"), moved(scene, right, down), scene.background);
  ASSERT_TRUE(shift) << right << ", " << down;
  EXPECT_NEAR(shift->x, right, tolerance);
  EXPECT_NEAR(shift->y, down, tolerance);
}

/// Whole pixels are known as such, up to their border.
TEST(PropertyPictureShift, SeveralWholePixelsAreToldExactly) {
  for (const auto& [x, y] : {std::pair(3, 2), std::pair(-1, 0), std::pair(0, 4)})
    expect_shift(any_scene(7), x, y, 0.02);
}

scene::Scene with_opacities(scene::Scene scene, double least, double most) {
  for (scene::SceneObject& object : scene.objects)
    for (Rgba& color : object.vertices().colors)
      color.a = float(least + (most - least) * double(color.a));
  return scene;
}

/// Of opacities of 0.003 to 0.02, far below what an 8-bit step of colours is wont to tell.
TEST(PropertyPictureShift, HalfPixelsOfFaintLayersAreTold) {
  const scene::Scene faint = with_opacities(any_scene(7), 0.003, 0.02);
  for (const auto& [x, y] : {std::pair(0.5, 0.0), std::pair(0.0, 0.5), std::pair(-0.5, 0.5)})
    expect_shift(faint, x, y, 0.1);
  EXPECT_THAT(given_faults(drawn(faint, "raytrace"), moved(faint, -0.5, 0.5), faint.background),
              ElementsAre(::testing::AllOf(HasSubstr("to the left and"), HasSubstr("down:"))));
}

/// A ground that covers everything leaves no edges of coverage: the colours have some.
TEST(PropertyPictureShift, ShiftsBeforeAGroundAreTold) {
  scene::Scene scene = any_scene(7);
  scene.objects.back() = sheet(-0.95, {0.9, 0.9, 0.9, 0.5});
  for (const auto& [x, y] : {std::pair(0.5, 0.0), std::pair(-0.5, -0.5), std::pair(2.0, 1.0)})
    expect_shift(scene, x, y, 0.1);
  const Image reference = drawn(scene, "raytrace");
  for (const char* method : {"weighted-average", "weighted-blended", "fourier"})
    EXPECT_THAT(given_faults(reference, drawn(scene, method), scene.background), IsEmpty())
        << method;
}

/// Where all is opaque nothing tells that colours are straight, but what is beside them is seen.
TEST(PropertyGivenFaultsOfBackgrounds, IsNamedBesideOpaqueThings) {
  const scene::Scene scene = with_opacities(any_scene(7), 1, 1);
  const Image reference = drawn(scene, "raytrace");
  const Image other = over(without_background(reference, scene.background), {0.9, 0.1, 0.1});
  EXPECT_THAT(given_faults(reference, other, scene.background),
              ElementsAre(HasSubstr("another background: (0.9, 0.1, 0.1)")));
}

/// What shows through layers that cover everything tells it, by the reference's opacities.
TEST(PropertyGivenFaultsOfBackgrounds, IsNamedBehindWhatCoversAll) {
  scene::Scene scene = any_scene(7);
  scene.objects.push_back(sheet(-0.95, {0.2, 0.4, 0.6, 0.5}));
  const Image reference = drawn(scene, "raytrace");
  const Image other = over(without_background(reference, scene.background), {0.9, 0.1, 0.1});
  for (const Image& image : {other, without_alpha(other)})
    EXPECT_THAT(given_faults(reference, image, scene.background),
                ElementsAre(HasSubstr("another background: (0.9, 0.1, 0.1)")));
}

/// Of a field of view that is off a shift explains little: it is none.
TEST(PropertyPictureShift, AnotherFieldOfViewIsNoShift) {
  for (const std::uint32_t seed : {1u, 7u, 9u})
    for (const double factor : {0.9, 0.95, 1.05, 1.1}) {
      scene::Scene scene = any_scene(seed);
      scene.camera.target.x = scene.camera.eye.x += 0.4;  // not in the middle: nearly a shift
      const Image reference = drawn(scene, "raytrace");
      scene.camera.height *= factor;
      EXPECT_THAT(given_faults(reference, drawn(scene, "raytrace"), scene.background), IsEmpty())
          << seed << ", " << factor;
    }
}

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
