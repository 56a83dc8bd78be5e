// SPDX-License-Identifier: GPL-3.0-or-later
#define GLM_ENABLE_EXPERIMENTAL  // rotate_vector.hpp, from GLM 1.0 on

#include "scene/view/camera_path.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtx/rotate_vector.hpp>

#include "core/error.h"
#include "scene/view/unit_scale.h"

namespace pellucid::scene {

std::vector<Camera> orbit(const Camera& camera, double degrees, int frames) {
  std::vector<Camera> path;
  const Vec3 arm = camera.eye - camera.target, axis = normalized_or_zero(camera.up);
  for (int i = 0; i < frames; ++i) {
    Camera at = camera;
    at.eye = camera.target + glm::rotate(arm, glm::radians(degrees * i / (frames - 1)), axis);
    path.push_back(at);
  }
  return path;
}

std::vector<Camera> between_keys(const std::vector<Camera>& keys, int frames) {
  if (keys.size() < 2) throw InputError("a camera path of one key; accepted: at least two");
  for (const Camera& key : keys)
    if (key.projection != keys.front().projection)
      throw InputError("the keys of a camera path differ in type; accepted: one type");
  std::vector<Camera> path;
  for (int i = 0; i < frames; ++i) {
    const double place = double(i) / (frames - 1) * double(keys.size() - 1);
    const std::size_t k = std::min(std::size_t(place), keys.size() - 2);
    const Camera &a = keys[k], &b = keys[k + 1];
    const double share = place - double(k);
    Camera at = a;
    at.eye = glm::mix(a.eye, b.eye, share);
    at.target = glm::mix(a.target, b.target, share);
    at.up = glm::mix(a.up, b.up, share);
    at.fov = std::lerp(a.fov, b.fov, share);
    at.height = std::lerp(a.height, b.height, share);
    path.push_back(at);
  }
  return path;
}

CameraMotion motion(const Camera& from, const Camera& to) {
  const Vec3 a = normalized_or_zero(from.target - from.eye),
             b = normalized_or_zero(to.target - to.eye), way = to.eye - from.eye;
  // By sine and cosine: the arc cosine alone loses half of the digits near 0.
  return {glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b))),
          std::hypot(way.x, way.y, way.z)};
}

}  // namespace pellucid::scene
