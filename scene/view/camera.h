// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/vec.h"

namespace pellucid::scene {

/// A Projection says whether rays leave the eye, or run parallel to the viewing axis.
enum class Projection { perspective, orthographic };

/// A Camera stands in the world, whose frame is right-handed. In view space x runs right and y up,
/// and the camera looks along -z; view depth is the distance along the viewing axis, in world
/// units, positive in front.
struct Camera {
  Projection projection = Projection::perspective;
  Vec3 eye{0, 0, 5};     // world
  Vec3 target{0, 0, 0};  // world
  Vec3 up{0, 1, 0};      // of any length
  double fov = 45;       // perspective: vertical, degrees, in (0, 180)
  double height = 2;     // orthographic: world units over the picture's height
};

/// Returns a perspective camera that looks at the box from above its front right corner and sees
/// all of it.
Camera fitted_camera(const Box3& box);

/// A CameraFrame is an orthonormal frame at the eye, in world coordinates.
struct CameraFrame {
  Vec3 eye, right, up, forward;
};

/// Returns the camera's frame. Throws InputError when eye equals target, when up is parallel to the
/// viewing axis, or when a number is not finite or outside its range.
CameraFrame camera_frame(const Camera& camera);

/// Returns half the picture's height: at distance 1 for a perspective camera, in world units
/// otherwise.
double half_height(const Camera& camera);

/// A Ray starts at a point of the world and runs through the picture.
struct Ray {
  Vec3 origin;     // world
  Vec3 direction;  // its component along the viewing axis is 1: the parameter is the view depth
};

/// A RayGenerator makes rays through points of the picture. It is built once per picture.
class RayGenerator {
 public:
  /// Takes the picture's size in pixels. Throws InputError for a camera that camera_frame()
  /// refuses.
  RayGenerator(const Camera& camera, int width, int height);

  /// Returns the ray through a point: x runs right from the left edge, y down from the top, in
  /// pixels; a pixel's centre is at +0.5.
  Ray ray(double x, double y) const;

  const CameraFrame& frame() const { return frame_; }
  Projection projection() const { return projection_; }

 private:
  CameraFrame frame_;
  Projection projection_;
  Vec3 step_x_, step_y_, corner_;  // corner_: direction, or origin offset, of the top left corner
};

/// Returns the distance of x along the viewing axis, in world units; negative behind the eye.
inline double view_depth(const CameraFrame& frame, const Vec3& x) {
  return glm::dot(frame.forward, x - frame.eye);
}

}  // namespace pellucid::scene
