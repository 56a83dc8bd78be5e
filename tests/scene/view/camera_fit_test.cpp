// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/view/camera_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace pellucid::scene {
namespace {

constexpr double used = 15.0 / 16;  // of the picture's width and height, without the margins

struct Ball {
  Vec3 center;
  double radius;
};

Camera fitted(const std::vector<Ball>& balls, const ViewDirection& from, double aspect,
              Projection projection = Projection::perspective, double fov = 45) {
  CameraFit fit(projection, fov, from, aspect);
  for (const Ball& ball : balls) fit.add(ball.center, ball.radius);
  return fit.camera();
}

/// How far the balls stick out of the sides of the picture without its margin, right, left, top,
/// bottom; in world units, at most 0 for what is seen.
std::array<double, 4> excess(const std::vector<Ball>& balls, const Camera& camera, double aspect) {
  const CameraFrame frame = camera_frame(camera);
  const double half = used * half_height(camera);
  std::array<double, 4> most;
  most.fill(-1e300);
  for (const auto& [x, r] : balls)
    for (int side = 0; side < 4; ++side) {
      const Vec3 across = (side % 2 ? -1.0 : 1.0) * (side < 2 ? frame.right : frame.up);
      const double reach = side < 2 ? half * aspect : half, along = glm::dot(across, x - frame.eye);
      const double beyond = camera.projection == Projection::perspective
                                ? (along - reach * view_depth(frame, x)) / std::hypot(1, reach)
                                : along - reach;
      most[std::size_t(side)] = std::max(most[std::size_t(side)], beyond + r);
    }
  return most;
}

TEST(UnitCameraFit, ABallIsSeenFromItsRadiusOverTheSine) {
  const double angle = std::atan(used * std::tan(std::numbers::pi / 8));  // half of 45°
  for (const ViewDirection& from : view_directions()) {
    const Camera camera = fitted({{{1, 2, 3}, 0.5}}, from, 1);
    // Some products of numbers up to 4, which round by 4e-16 each.
    EXPECT_NEAR(glm::length(camera.eye - Vec3(1, 2, 3)), 0.5 / std::sin(angle), 1e-14);
    EXPECT_NEAR(glm::length(camera.target - Vec3(1, 2, 3)), 0, 1e-14);
    const Vec3 away = glm::normalize(camera.eye - Vec3(1, 2, 3));
    EXPECT_NEAR(glm::length(away - glm::normalize(from.toward_eye)), 0, 1e-14) << from.name;
  }
}

TEST(UnitCameraFit, AnOrthographicPictureIsAsHighAsWhatItShows) {
  // A plate of 4 × 2 from the front: in a square picture its width counts, in one of 4:1 its
  // height.
  const std::vector<Ball> plate{{{0, 0, 0}, 0}, {{4, 2, 0}, 0}};
  const ViewDirection front{"front", "", {0, 0, 1}, {0, 1, 0}};
  EXPECT_NEAR(fitted(plate, front, 1, Projection::orthographic).height, 4 / used, 1e-14);
  EXPECT_NEAR(fitted(plate, front, 4, Projection::orthographic).height, 2 / used, 1e-14);
  EXPECT_EQ(fitted(plate, front, 1, Projection::orthographic).target, Vec3(2, 1, 0));
}

TEST(PropertyCameraFit, TouchesTwoOppositeSidesAndIsCentredBetweenTheOthers) {
  std::mt19937 random(20);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto vector = [&] { return Vec3(unit(random), unit(random), unit(random)); };
  for (int round = 0; round < 500; ++round) {
    const double scale = std::pow(10, 5 * unit(random));
    std::vector<Ball> balls;
    for (int i = 0; i < 1 + round % 7; ++i)
      balls.push_back({scale * (vector() + 10.0 * vector()), scale * std::abs(unit(random))});
    const ViewDirection from{"", "", vector(), vector()};
    const double aspect = std::exp(unit(random)), fov = 60 + 50 * unit(random);
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
      const Camera camera = fitted(balls, from, aspect, projection, fov);
      const auto [right, left, top, bottom] = excess(balls, camera, aspect);
      // The eye is at most some 100 sizes away: 1e-14 of that, and of the products with it.
      const double rounding = 1e-11 * scale;
      EXPECT_LE(std::max({right, left, top, bottom}), rounding);
      EXPECT_NEAR(std::max(std::min(right, left), std::min(top, bottom)), 0, rounding);
      EXPECT_NEAR(right, left, rounding);
      EXPECT_NEAR(top, bottom, rounding);
    }
  }
}

TEST(UnitCameraFit, SeesOnePointAndWhatLiesInOnePlaneWithTheEye) {
  const ViewDirection front{"front", "", {0, 0, 1}, {0, 1, 0}};
  for (const Projection projection : {Projection::perspective, Projection::orthographic})
    for (const std::vector<Ball>& balls :
         {std::vector<Ball>{{{3, 3, 3}, 0}}, std::vector<Ball>{{{3, 3, 3}, 0}, {{3, 3, 5}, 0}},
          std::vector<Ball>{{{3e12, 3, 3}, 0}}}) {
      const Camera camera = fitted(balls, front, 1, projection);
      const CameraFrame frame = camera_frame(camera);
      for (const Ball& ball : balls) EXPECT_GT(view_depth(frame, ball.center), 0);
    }
}

}  // namespace
}  // namespace pellucid::scene
