// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "scene/view/camera.h"

namespace pellucid::scene {

/// A ViewDirection is a side from which a scene may be looked at.
struct ViewDirection {
  std::string_view name;  // as --view takes it
  std::string_view title;
  Vec3 toward_eye;  // from the scene, of any length
  Vec3 up;
};

/// Returns the table of directions; the first is that of a scene without a camera.
std::span<const ViewDirection> view_directions();

/// A CameraFit finds the camera that looks in a given direction and sees all balls that it has been
/// shown, as large as they can be: the picture without its margin of 1/32 on each side touches them
/// at two opposite sides, and they are in its middle.
///
/// The four sides of a perspective picture are planes through the eye. With n the outer normal of
/// one, all balls lie within when n · eye ≥ s = max(n · x + r), the support of the balls. Two
/// opposite sides have n = ±cos(a) right - sin(a) forward, a half the angle between them: both hold
/// up to forward · eye = -(s₁ + s₂) / (2 sin a), and there right · eye = (s₁ - s₂) / (2 cos a).
/// Exact but for rounding.
class CameraFit {
 public:
  /// Takes the projection, the vertical angle, and the picture's width over its height.
  CameraFit(Projection projection, double fov, const ViewDirection& from, double aspect);

  /// Adds the ball of this radius around x, in world units.
  void add(const Vec3& x, double radius);

  /// Returns the camera; balls that are all one point get one from a distance of 1, or of a
  /// millionth of the point's from the origin, if that is more.
  Camera camera() const;

 private:
  Camera at(const Vec3& eye, double distance) const;
  Camera perspective() const;
  Camera orthographic() const;
  double extent(int axis) const { return most_[axis] + most_[axis + 3]; }

  Projection projection_;
  double fov_, aspect_;
  Vec3 up_;                         // the direction's, which the camera keeps to turn about
  CameraFrame frame_;               // at the origin
  std::array<double, 2> tangent_;   // of half the angle, without the margin: across, up
  std::array<Vec3, 4> sides_;       // outer normals: right, left, top, bottom
  std::array<double, 4> supports_;  // of the sides
  std::array<double, 6> most_;      // along ±right, ±up, ±forward: 0, 1, 2 and 3, 4, 5
  Vec3 origin_{0};                  // the first ball's centre: sums keep their digits
  bool empty_ = true;
};

}  // namespace pellucid::scene
