// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/view/camera.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/error.h"
#include "scene/view/unit_scale.h"

namespace pellucid::scene {
namespace {

bool finite(const Vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

std::string text(const Vec3& v) { return fmt::format("[{}, {}, {}]", v.x, v.y, v.z); }

void check(const Camera& camera) {
  if (!finite(camera.eye)) throw InputError("camera.eye: accepted: three finite numbers");
  if (!finite(camera.target)) throw InputError("camera.target: accepted: three finite numbers");
  if (!finite(camera.up)) throw InputError("camera.up: accepted: three finite numbers");
  if (camera.projection == Projection::perspective && !(camera.fov > 0 && camera.fov < 180))
    throw InputError(
        fmt::format("camera.fov: {}; accepted: degrees between 0 and 180, exclusive", camera.fov));
  if (camera.projection == Projection::orthographic &&
      !(camera.height > 0 && std::isfinite(camera.height)))
    throw InputError(
        fmt::format("camera.height: {}; accepted: a finite length above 0", camera.height));
}

}  // namespace

Camera fitted_camera(const Box3& box) {
  Camera camera;
  const double radius = std::max(box.diagonal() / 2, std::numeric_limits<double>::min());
  const double distance = radius / std::sin(camera.fov * std::numbers::pi / 360);
  camera.target = box.center();
  camera.eye = camera.target + distance * glm::normalize(Vec3(2, 1.5, 3));
  return camera;
}

CameraFrame camera_frame(const Camera& camera) {
  check(camera);
  const Vec3 axis = with_unit_exponent(camera.target - camera.eye);
  const double distance = glm::length(axis);
  if (!(distance > 0))
    throw InputError(fmt::format("camera.target: {} equals camera.eye; accepted: another point",
                                 text(camera.target)));
  const Vec3 forward = axis / distance;
  const Vec3 up = with_unit_exponent(camera.up);
  const Vec3 side = glm::cross(forward, up);
  const double sine = glm::length(side);
  // Below this the direction of `side` is rounding noise.
  if (!(sine > 1e-12 * glm::length(up)))
    throw InputError(
        fmt::format("camera.up: {} is parallel to the viewing axis; accepted: any other direction",
                    text(camera.up)));
  const Vec3 right = side / sine;
  return {camera.eye, right, glm::cross(right, forward), forward};
}

double half_height(const Camera& camera) {
  if (camera.projection == Projection::orthographic) return camera.height / 2;
  return std::tan(camera.fov * std::numbers::pi / 360);
}

RayGenerator::RayGenerator(const Camera& camera, int width, int height)
    : frame_(camera_frame(camera)), projection_(camera.projection) {
  const double pixel = 2 * half_height(camera) / height;  // pixels are square
  step_x_ = pixel * frame_.right;
  step_y_ = -pixel * frame_.up;
  corner_ = -0.5 * width * step_x_ - 0.5 * height * step_y_;
}

Ray RayGenerator::ray(double x, double y) const {
  const Vec3 offset = corner_ + x * step_x_ + y * step_y_;
  if (projection_ == Projection::orthographic) return {frame_.eye + offset, frame_.forward};
  return {frame_.eye, frame_.forward + offset};
}

}  // namespace pellucid::scene
