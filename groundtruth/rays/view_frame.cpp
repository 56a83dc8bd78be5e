// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/rays/view_frame.h"

#include "scene/view/unit_scale.h"

namespace pellucid::groundtruth {

ViewFrame::ViewFrame(const scene::Scene& scene, const Box3& bounds)
    : camera_(scene::camera_frame(scene.camera)),
      projection_(scene.camera.projection),
      scale_(scene::unit_scale(bounds)),
      pixel_(2 * scene::half_height(scene.camera) / scene.height),
      center_x_(0.5 * scene.width),
      center_y_(0.5 * scene.height) {
  if (projection_ == scene::Projection::orthographic) pixel_ *= scale_;
}

Vec3 ViewFrame::from_world(const Vec3& x) const { return vector_from_world(x - camera_.eye); }

Vec3 ViewFrame::vector_from_world(const Vec3& d) const {
  return scale_ *
         Vec3(glm::dot(camera_.right, d), glm::dot(camera_.up, d), glm::dot(camera_.forward, d));
}

PictureRay ViewFrame::ray(double px, double py) const {
  return {(px - center_x_) * pixel_, (center_y_ - py) * pixel_, projection_};
}

Vec3 ViewFrame::world_direction(const PictureRay& ray) const {
  if (ray.projection == scene::Projection::orthographic) return camera_.forward;
  return camera_.forward + ray.x * camera_.right + ray.y * camera_.up;
}

}  // namespace pellucid::groundtruth
