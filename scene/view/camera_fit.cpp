// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/view/camera_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace pellucid::scene {
namespace {

/// What the margins leave of the picture.
constexpr double used_share = 1 - 2.0 / 32;

constexpr double infinity = std::numeric_limits<double>::infinity();

CameraFrame frame_of(const ViewDirection& from) {
  return camera_frame({.eye = Vec3(0), .target = -from.toward_eye, .up = from.up});
}

}  // namespace

std::span<const ViewDirection> view_directions() {
  static const ViewDirection rows[] = {
      {"corner", "from above the front right corner", {2, 1.5, 3}, {0, 1, 0}},
      {"iso", "along the diagonal of a cube, y up", {1, 1, 1}, {0, 1, 0}},
      {"+x", "from the right, y up", {1, 0, 0}, {0, 1, 0}},
      {"-x", "from the left, y up", {-1, 0, 0}, {0, 1, 0}},
      {"+y", "from above, x to the right", {0, 1, 0}, {0, 0, -1}},
      {"-y", "from below, x to the right", {0, -1, 0}, {0, 0, 1}},
      {"+z", "from the front, y up", {0, 0, 1}, {0, 1, 0}},
      {"-z", "from behind, y up", {0, 0, -1}, {0, 1, 0}}};
  return rows;
}

CameraFit::CameraFit(Projection projection, double fov, const ViewDirection& from, double aspect)
    : projection_(projection), fov_(fov), aspect_(aspect), up_(from.up), frame_(frame_of(from)) {
  const double half = used_share * std::tan(fov * std::numbers::pi / 360);
  tangent_ = {half * aspect, half};
  for (int axis = 0; axis < 2; ++axis) {
    const Vec3 across = axis == 0 ? frame_.right : frame_.up;
    const double angle = std::atan(tangent_[std::size_t(axis)]);
    for (int side = 0; side < 2; ++side)
      sides_[std::size_t(2 * axis + side)] =
          (side == 0 ? std::cos(angle) : -std::cos(angle)) * across -
          std::sin(angle) * frame_.forward;
  }
  supports_.fill(-infinity);
  most_.fill(-infinity);
}

void CameraFit::add(const Vec3& x, double radius) {
  if (empty_) origin_ = x;
  empty_ = false;
  const Vec3 from_origin = x - origin_;
  for (std::size_t k = 0; k < 4; ++k)
    supports_[k] = std::max(supports_[k], glm::dot(sides_[k], from_origin) + radius);
  const Vec3 along(glm::dot(frame_.right, from_origin), glm::dot(frame_.up, from_origin),
                   glm::dot(frame_.forward, from_origin));
  for (int axis = 0; axis < 3; ++axis) {
    double& most = most_[std::size_t(axis)];
    double& least = most_[std::size_t(axis) + 3];
    most = std::max(most, along[axis] + radius);
    least = std::max(least, -along[axis] + radius);
  }
}

Camera CameraFit::camera() const {
  if (empty_) return Camera{.projection = projection_, .fov = fov_};
  return projection_ == Projection::perspective ? perspective() : orthographic();
}

/// `eye` is from origin_; the target lies at `distance` before it.
Camera CameraFit::at(const Vec3& eye, double distance) const {
  Camera camera{.projection = projection_, .up = up_, .fov = fov_};
  camera.eye = origin_ + eye;
  camera.target = origin_ + (eye + distance * frame_.forward);
  return camera;
}

Camera CameraFit::perspective() const {
  Vec3 place(0);  // of the eye, along right, up, forward
  place.z = infinity;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double angle = std::atan(tangent_[axis]);
    const double first = supports_[2 * axis], second = supports_[2 * axis + 1];
    place.z = std::min(place.z, -(first + second) / (2 * std::sin(angle)));
    place[int(axis)] = (first - second) / (2 * std::cos(angle));
  }
  const double middle = (most_[2] - most_[5]) / 2;
  const double away = std::max(1.0, 1e-6 * glm::length(origin_));
  const bool is_point = extent(0) == 0 && extent(1) == 0 && extent(2) == 0;
  if (is_point) place.z = middle - away;
  // What is nearest may lie where the sides of the picture meet: nothing is seen of what is there.
  if (const double nearest = -most_[5]; !(nearest > place.z))
    place.z = nearest - std::max(extent(2), away);
  return at(place.x * frame_.right + place.y * frame_.up + place.z * frame_.forward,
            middle - place.z);
}

Camera CameraFit::orthographic() const {
  const double size = std::max({extent(0), extent(1), extent(2)});
  const double away = size > 0 ? size : std::max(1.0, 1e-6 * glm::length(origin_));
  const Vec3 middle = (most_[0] - most_[3]) / 2 * frame_.right +
                      (most_[1] - most_[4]) / 2 * frame_.up +
                      (most_[2] - most_[5]) / 2 * frame_.forward;
  Camera camera = at(middle - away * frame_.forward, away);
  const double height = std::max(extent(1), extent(0) / aspect_) / used_share;
  camera.height = height > 0 ? height : away;
  return camera;
}

}  // namespace pellucid::scene
