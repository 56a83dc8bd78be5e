// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.h"

namespace pellucid::groundtruth {

/// A PictureRay runs through a point of the picture, in view coordinates. Perspective: from the eye
/// (the origin) through (x, y, 1). Orthographic: from (x, y, 0) along +z.
struct PictureRay {
  double x, y;
  scene::Projection projection;
};

/// A ViewFrame maps to the view coordinates in which crossings are decided: x right, y up, z the
/// view depth, the eye at the origin, in units (world lengths times a power of two, see
/// unit_scale()). Vertices are rounded to them once, so that triangles that share a vertex still
/// share it.
class ViewFrame {
 public:
  explicit ViewFrame(const scene::Scene& scene) : ViewFrame(scene, scene.bounds()) {}
  /// Takes the box, in world units, of all that is drawn: more than the scene's own where the scene
  /// is a part.
  ViewFrame(const scene::Scene& scene, const Box3& bounds);

  /// Maps a position in the world to view coordinates.
  Vec3 from_world(const Vec3& x) const;
  /// Maps a difference of positions in the world.
  Vec3 vector_from_world(const Vec3& d) const;
  double units_per_length() const { return scale_; }
  const scene::CameraFrame& camera() const { return camera_; }

  /// Returns the ray through a point of the picture: px runs right, py down, in pixels from the
  /// picture's top left corner.
  PictureRay ray(double px, double py) const;

  /// Returns the ray's direction in the world's axes; not normalized.
  Vec3 world_direction(const PictureRay& ray) const;

 private:
  scene::CameraFrame camera_;
  scene::Projection projection_;
  double scale_;                // units per world length
  double pixel_;                // side of a pixel, as PictureRay counts
  double center_x_, center_y_;  // of the picture, pixels
};

}  // namespace pellucid::groundtruth
