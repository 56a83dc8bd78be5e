// SPDX-License-Identifier: GPL-3.0-or-later
// Each fault that a picture from elsewhere may have is found and said; a method's own error is
// none.
#include "compare/pictures/faults/given_faults.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "compare/pictures/faults/picture_shift.h"
#include "compare/pictures/image_file.h"
#include "tests/compare/pictures/faults/faulty_pictures.h"

namespace pellucid::compare {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

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

}  // namespace
}  // namespace pellucid::compare
