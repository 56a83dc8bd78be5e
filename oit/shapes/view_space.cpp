// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/shapes/view_space.h"

namespace pellucid::oit {
namespace {

// Perspective: what lies nearer to the eye than this, in units of the farthest depth, is clipped.
// Any positive number would do; this one keeps x / w finite in float.
constexpr double nearest = 1e-6;

}  // namespace

ViewSpace::ViewSpace(const scene::Scene& scene, const scene::DepthRange& range)
    : frame_(scene::camera_frame(scene.camera)),
      projection_(scene.camera.projection),
      range_(range),
      size_(scene.width, scene.height),
      half_height_(scene::half_height(scene.camera)) {
  unit_ = projection_ == scene::Projection::perspective ? range_.far : half_height_;
}

ViewSpace::Uniforms ViewSpace::uniforms(const Vec2& sample) const {
  const double y_scale = projection_ == scene::Projection::perspective ? 1 / half_height_ : 1;
  Uniforms u;
  u.clip_scale = {float(y_scale * size_.y / size_.x), float(-y_scale)};
  // A pixel is 2 / size wide in clip space, where y runs down as in the picture.
  u.clip_shift = glm::vec2(2.0 * (0.5 - sample) / size_);
  // View depth in units of the farthest: z = z0 + z1 d.
  const double z0 = range_.near / range_.far, z1 = (range_.far - range_.near) / range_.far;
  if (projection_ == scene::Projection::perspective) {
    // w = z and z_clip = z - 2 nearest: inside [-w, w] exactly when z >= nearest.
    u.clip_w = {z0, z1};
    u.clip_z = {z0 - 2 * nearest, z1};
  } else {
    // w = 1 and z_clip = z - 1: inside [-1, 1] exactly when 0 <= z <= 2.
    u.clip_w = {1, 0};
    u.clip_z = {z0 - 1, z1};
  }
  return u;
}

}  // namespace pellucid::oit
