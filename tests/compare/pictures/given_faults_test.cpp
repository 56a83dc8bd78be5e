// SPDX-License-Identifier: GPL-3.0-or-later
// Each fault that a picture from elsewhere may have is found and said; a method's own error is
// none.
#include "compare/pictures/given_faults.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "compare/methods/methods.h"
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
  const Shift shift = coverage_shift(reference_, image, scene_.background);
  EXPECT_NEAR(shift.x, 0.5, 4 * shift.uncertainty);
  EXPECT_NEAR(shift.y, -1.5, 4 * shift.uncertainty);
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

}  // namespace
}  // namespace pellucid::compare
