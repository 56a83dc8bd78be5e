// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.h"
#include "scene/view_depth.h"

namespace pellucid::oit {

/// A ViewSpace is the frame in which geometry is uploaded: x right and y up in view units, in place
/// of z the depth d of the scene, in (0, 1). A view unit is the depth of the range's far end
/// (perspective) or half the picture's height (orthographic).
///
/// A renderer's camera never changes, so vertices are moved into its frame in double and only then
/// rounded to float: neither a scene far from the origin nor a sliver of a depth range loses
/// digits, as it would with a float matrix over world positions.
class ViewSpace {
 public:
  ViewSpace(const scene::Scene& scene, const scene::DepthRange& range);

  const scene::CameraFrame& frame() const { return frame_; }
  scene::Projection projection() const { return projection_; }
  /// Returns a position of the world in this frame, as it is, and as it is uploaded.
  ///@{
  Vec3 exact_position(const Vec3& world) const {
    const Vec3 x = world - frame_.eye;
    return {glm::dot(frame_.right, x) / unit_, glm::dot(frame_.up, x) / unit_,
            range_.normalized(glm::dot(frame_.forward, x))};
  }
  glm::vec3 position(const Vec3& world) const { return glm::vec3(exact_position(world)); }
  ///@}
  glm::vec3 direction(const Vec3& world) const {
    return {glm::dot(frame_.right, world), glm::dot(frame_.up, world),
            glm::dot(frame_.forward, world)};
  }
  /// Returns a position of the world in view units in all three axes, z the view depth.
  Vec3 view_position(const Vec3& world) const {
    const Vec3 x = world - frame_.eye;
    return Vec3(glm::dot(frame_.right, x), glm::dot(frame_.up, x), glm::dot(frame_.forward, x)) /
           unit_;
  }
  /// Returns a length in view units.
  double exact_length(double world) const { return world / unit_; }

  /// Returns what brings x and y of view units to clip space, y up.
  Vec2 clip_scale() const { return clip_scale_; }
  /// Returns the homogeneous coordinate of what has depth d: view units, or 1 (orthographic).
  double w(double d) const { return w_.x + w_.y * d; }
  /// Returns the least d that is drawn: it lies at the eye, or next to it.
  double nearest_drawn() const;

  /// Returns the picture's size in pixels.
  Vec2 size() const { return size_; }

  /// Uniforms are the block `View` of view.glsl.
  struct Uniforms {
    glm::vec2 clip_scale, clip_shift, clip_w, clip_z;
    Vec2 ray_scale, ray_shift, view_depth;
  };
  /// Returns the block for a `sample` of the pixel, in pixels from its top left corner (see
  /// pixel_samples.h).
  Uniforms uniforms(const Vec2& sample) const;

 private:
  scene::CameraFrame frame_;
  scene::Projection projection_;
  scene::DepthRange range_;
  Vec2 size_;    // of the picture, pixels
  double unit_;  // world units per view unit
  Vec2 clip_scale_, w_;
};
static_assert(sizeof(ViewSpace::Uniforms) == 80);

}  // namespace pellucid::oit
