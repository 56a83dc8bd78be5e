// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/shapes/view_space.h"

namespace pellucid::oit {
namespace {

/// Perspective: what lies nearer to the eye than this, in units of the farthest depth, is clipped.
/// Where the range begins in front of the eye, at z0, nothing in the picture is nearer than half of
/// that. Where it begins at the eye any positive number would do; this one keeps x / w finite in
/// float.
double nearest(double z0) { return z0 > 0 ? 0.5 * z0 : 1e-9; }

}  // namespace

ViewSpace::ViewSpace(const scene::Scene& scene, const scene::DepthRange& range)
    : frame_(scene::camera_frame(scene.camera)),
      projection_(scene.camera.projection),
      range_(range),
      size_(scene.width, scene.height) {
  const bool perspective = projection_ == scene::Projection::perspective;
  const double half_height = scene::half_height(scene.camera);
  unit_ = perspective ? range_.far : half_height;
  const double y_scale = perspective ? 1 / half_height : 1;
  clip_scale_ = {y_scale * size_.y / size_.x, y_scale};
  // View depth in units of the farthest: z = z0 + z1 d.
  const double z0 = range_.near / range_.far, z1 = (range_.far - range_.near) / range_.far;
  w_ = perspective ? Vec2(z0, z1) : Vec2(1, 0);
}

double ViewSpace::nearest_drawn() const {
  if (projection_ == scene::Projection::orthographic) return range_.normalized(0);
  return (nearest(w_.x) - w_.x) / w_.y;
}

ViewSpace::Uniforms ViewSpace::uniforms(const Vec2& sample) const {
  Uniforms u;
  u.clip_scale = {float(clip_scale_.x), float(-clip_scale_.y)};
  // A pixel is 2 / size wide in clip space, where y runs down as in the picture.
  u.ray_shift = 2.0 * (0.5 - sample) / size_;
  u.clip_shift = glm::vec2(u.ray_shift);
  u.ray_scale = {1 / clip_scale_.x, -1 / clip_scale_.y};
  u.view_depth = {range_.near / unit_, (range_.far - range_.near) / unit_};
  u.clip_w = glm::vec2(w_);
  if (projection_ == scene::Projection::perspective) {
    // w = z and z_clip = z - 2 nearest: inside [-w, w] exactly when z >= nearest.
    u.clip_z = {w_.x - 2 * nearest(w_.x), w_.y};
  } else {
    // w = 1 and z_clip = z - 1, z in units of the farthest: inside [-1, 1] exactly when
    // 0 <= z <= 2.
    u.clip_z = {range_.near / range_.far - 1, (range_.far - range_.near) / range_.far};
  }
  return u;
}

}  // namespace pellucid::oit
