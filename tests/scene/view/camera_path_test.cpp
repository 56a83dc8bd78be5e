// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/view/camera_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/error.h"

namespace pellucid::scene {
namespace {

TEST(UnitCameraPath, AnOrbitGoesRoundTheTargetCounterclockwise) {
  const Camera camera{.eye = {3, 2, 1}, .target = {1, 2, 1}, .up = {0, 0, 5}};
  const auto path = orbit(camera, 90, 4);
  ASSERT_EQ(path.size(), 4u);
  for (int i = 0; i < 4; ++i) {
    const double angle = i * std::numbers::pi / 6;
    const Vec3 expected(1 + 2 * std::cos(angle), 2 + 2 * std::sin(angle), 1);
    // Sines, products and sums up to 4 round by 1.1e-16 to 4.4e-16; here they round alike on both
    // sides.
    EXPECT_LT(glm::length(path[std::size_t(i)].eye - expected), 1e-15) << i;
    EXPECT_EQ(path[std::size_t(i)].target, camera.target);
  }
  for (int i = 1; i < 4; ++i) {
    const CameraMotion step = motion(path[std::size_t(i) - 1], path[std::size_t(i)]);
    // Eyes are off by an ulp of 4.4e-16 at a radius of 2, and 57 degrees are a radian: some 3e-14.
    EXPECT_NEAR(step.degrees, 30, 1e-13);
    EXPECT_NEAR(step.distance, 4 * std::sin(std::numbers::pi / 12), 1e-14);
  }
}

/// Of `up` the direction counts, whose square may be no number; a turn has no size either.
TEST(UnitCameraPath, LengthsDoNotMatter) {
  const Camera unit{.eye = {3, 2, 1}, .target = {1, 2, 1}, .up = {0, 0, 1}};
  for (const double length : {1e200, 1e-200}) {
    Camera camera = unit;
    camera.up *= length;
    EXPECT_EQ(orbit(camera, 90, 4)[3].eye, orbit(unit, 90, 4)[3].eye) << length;
    const Camera before{.eye = {0, 0, length}, .target = {0, 0, 0}},
        after{.eye = {length, 0, 0}, .target = {0, 0, 0}};
    EXPECT_NEAR(motion(before, after).degrees, 90, 1e-13) << length;
    EXPECT_NEAR(motion(before, after).distance / length, std::numbers::sqrt2, 1e-15) << length;
  }
}

TEST(UnitCameraPath, KeysArePassedAtEqualSteps) {
  const Camera a{.eye = {0, 0, 5}, .fov = 40}, b{.eye = {2, 0, 5}, .fov = 60},
      c{.eye = {2, 4, 5}, .target = {1, 0, 0}, .fov = 60};
  const auto path = between_keys({a, b, c}, 5);
  ASSERT_EQ(path.size(), 5u);
  EXPECT_EQ(path[0].eye, a.eye);
  EXPECT_EQ(path[1].eye, Vec3(1, 0, 5));
  EXPECT_EQ(path[1].fov, 50);
  EXPECT_EQ(path[2].eye, b.eye);
  EXPECT_EQ(path[3].eye, Vec3(2, 2, 5));
  EXPECT_EQ(path[3].target, Vec3(0.5, 0, 0));
  EXPECT_EQ(path[4].eye, c.eye);
  EXPECT_THROW(between_keys({a}, 5), InputError);
  EXPECT_THROW(between_keys({a, {.projection = Projection::orthographic}}, 5), InputError);
}

// The arc cosine of 1 - 5e-19 would be 0.
TEST(UnitCameraPath, SmallTurnsAreMeasured) {
  const Camera camera{.eye = {0, 0, 5}};
  EXPECT_NEAR(motion(camera, orbit(camera, 1e-7, 2)[1]).degrees, 1e-7, 1e-14);
  EXPECT_EQ(motion(camera, camera).degrees, 0);
}

}  // namespace
}  // namespace pellucid::scene
