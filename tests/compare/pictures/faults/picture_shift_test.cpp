// SPDX-License-Identifier: GPL-3.0-or-later
// Shifts are found with their sizes; what is no shift is none.
#include "compare/pictures/faults/picture_shift.h"

#include <gmock/gmock.h>

#include "compare/pictures/faults/given_faults.h"
#include "tests/compare/pictures/faults/faulty_pictures.h"

namespace pellucid::compare {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(PropertyPictureShift, AnEmptyPictureIsNotShifted) {
  const scene::Scene scene = any_scene(7);
  const Image nothing(width, height, Rgba(scene.background, 0));
  EXPECT_THAT(given_faults(drawn(scene, "raytrace"), nothing, scene.background), IsEmpty());
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

}  // namespace
}  // namespace pellucid::compare
