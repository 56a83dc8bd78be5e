// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/view/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/error.h"
#include "scene/view/unit_scale.h"
#include "scene/view_depth.h"
#include "tests/support/scenes.h"

namespace pellucid::scene {
namespace {

using namespace testing;

void expect_near(const Vec3& a, const Vec3& b, double tolerance) {
  EXPECT_LE(glm::length(a - b), tolerance) << a.x << " " << a.y << " " << a.z;
}

TEST(UnitCamera, FrameIsRightHandedAndOrthonormal) {
  const CameraFrame frame = camera_frame({.eye = {1, 2, 3}, .target = {4, -1, 7}, .up = {0, 2, 1}});
  // Products of unit vectors round by 1.1e-16 each: six of a cross product, three of a dot product,
  // and those of the vectors themselves.
  expect_near(glm::cross(frame.right, frame.up), -frame.forward, 1e-15);
  EXPECT_NEAR(glm::dot(frame.right, frame.up), 0, 1e-15);
  EXPECT_GT(glm::dot(frame.up, Vec3(0, 2, 1)), 0);
}

TEST(UnitCamera, PerspectiveRaysReachTheCornersOfThePicture) {
  // fov 90°: at distance 1 the picture is 2 high; 200 × 100 pixels make it 4 wide.
  const RayGenerator rays({.eye = {0, 0, 5}, .target = {0, 0, 0}, .fov = 90}, 200, 100);
  expect_near(rays.ray(100, 50).direction, {0, 0, -1}, 1e-15);
  expect_near(rays.ray(0, 0).direction, {-2, 1, -1}, 1e-15);
  expect_near(rays.ray(200, 100).direction, {2, -1, -1}, 1e-15);
  expect_near(rays.ray(0, 0).origin, {0, 0, 5}, 0);
}

TEST(UnitCamera, OrthographicRaysAreParallel) {
  const RayGenerator rays({.projection = Projection::orthographic, .eye = {0, 0, 5}, .height = 2},
                          100, 100);
  expect_near(rays.ray(0, 0).origin, {-1, 1, 5}, 1e-15);
  expect_near(rays.ray(0, 0).direction, {0, 0, -1}, 0);
}

TEST(UnitCamera, RefusesWhatSeesNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(camera_frame({.eye = {1, 1, 1}, .target = {1, 1, 1}}), InputError);
  EXPECT_THROW(camera_frame({.eye = {0, 0, 5}, .up = {0, 0, 1}}), InputError);
  EXPECT_THROW(camera_frame({.eye = {0, nan, 5}}), InputError);
  for (const double fov : {0.0, 180.0, -45.0, nan})
    EXPECT_THROW(camera_frame({.fov = fov}), InputError);
  for (const double height : {0.0, -1.0, nan})
    EXPECT_THROW(camera_frame({.projection = Projection::orthographic, .height = height}),
                 InputError);
}

TEST(UnitCamera, AFittedCameraSeesTheWholeBox) {
  Box3 box;
  box.extend({-3, 10, 5});
  box.extend({40, 11, 7});
  const Camera camera = fitted_camera(box);
  const CameraFrame frame = camera_frame(camera);
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 x(corner & 1 ? box.min.x : box.max.x, corner & 2 ? box.min.y : box.max.y,
                 corner & 4 ? box.min.z : box.max.z);
    const double z = view_depth(frame, x);
    ASSERT_GT(z, 0);
    EXPECT_LT(std::abs(glm::dot(frame.right, x - frame.eye)) / z, half_height(camera));
    EXPECT_LT(std::abs(glm::dot(frame.up, x - frame.eye)) / z, half_height(camera));
  }
}

TEST(UnitViewDepth, IsTightAndInsideTheOpenInterval) {
  Scene scene = stack(3, 4, 4, [](int) { return Rgba(1); });  // z = 1, 0, -1 seen from z = 5
  const DepthRange range = depth_range(scene);
  EXPECT_GT(float(range.normalized(4)), 0.f);
  EXPECT_LT(float(range.normalized(6)), 1.f);
  // The margins are a 1e-5th of the length.
  EXPECT_NEAR(range.normalized(4), 0, 1.01e-5);
  EXPECT_NEAR(range.normalized(5), 0.5, 1e-15);
  EXPECT_NEAR(range.normalized(6), 1, 1.01e-5);
}

TEST(UnitViewDepth, OneSingleDepthLiesInTheMiddle) {
  const Scene scene = stack(1, 4, 4, [](int) { return Rgba(1); });
  EXPECT_NEAR(depth_range(scene).normalized(5), 0.5, 1e-15);
}

TEST(UnitViewDepth, StartsAtTheEyeWhenTheSceneReachesBehindIt) {
  Scene scene = stack(2, 4, 4, [](int) { return Rgba(1); });
  scene.camera.eye = {0, 0, 0};
  scene.camera.target = {0, 0, -1};
  // From z = 1 behind the eye, or more, to z = -1 in the picture.
  for (Vec3& x : scene.objects[0].mesh().positions) x.z = x.x;
  // The margin, a 1e-5th of a depth range of length 1.
  EXPECT_NEAR(depth_range(scene).near, 0, 1.01e-5);
  scene.camera.target = {0, 0, 1};
  scene.objects.resize(1);
  scene.objects[0].mesh() = full_layer(-1, Rgba(1));
  EXPECT_THROW(depth_range(scene), InputError);
}

TEST(UnitUnitScale, IsThePowerOfTwoThatFitsTheUnitBox) {
  for (const double size : {1e-10, 0.3, 1.0, 2.0, 7.0, 1e10}) {
    Box3 box;
    box.extend({100, 0, 3});
    box.extend({100 + size, size / 2, 3});
    const double scale = unit_scale(box);
    int exponent = 0;
    EXPECT_EQ(std::frexp(scale, &exponent), 0.5);
    // A coordinate near 100 is known to 1.4e-14, which at size 1e-10 is a part of 1.4e-4.
    EXPECT_GT(scale * size / 2, 0.5 * (1 - 1e-3));
    EXPECT_LE(scale * size / 2, 1 + 1e-3);
  }
  EXPECT_EQ(unit_scale(Box3{}), 1);
  EXPECT_EQ(unit_scale(Box3{Vec3(5), Vec3(5)}), 1);
}

}  // namespace
}  // namespace pellucid::scene
