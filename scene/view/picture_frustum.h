// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "core/vec.h"
#include "scene/view/camera.h"

namespace pellucid::scene {

/// A DepthInterval holds view depths from `min` to `max`, in world units; empty at first.
struct DepthInterval {
  double min = std::numeric_limits<double>::infinity();
  double max = -std::numeric_limits<double>::infinity();

  bool empty() const { return !(min <= max); }
  void extend(const DepthInterval& other) {
    min = other.min < min ? other.min : min;
    max = other.max > max ? other.max : max;
  }
};

/// A PictureFrustum is what the camera's rays through a picture pass, from the eye on. Its view
/// coordinates are x right, y up, z the view depth, the eye at the origin, in world units.
class PictureFrustum {
 public:
  /// Takes the picture's size in pixels. Throws InputError for a camera that camera_frame()
  /// refuses.
  PictureFrustum(const Camera& camera, int width, int height);

  const CameraFrame& frame() const { return frame_; }
  Vec3 from_world(const Vec3& x) const;
  /// Returns the largest coordinate that a point of the picture has at depth z.
  double reach(double z) const;

  /// Returns the planes, one bit each, beyond which the point lies (view coordinates): a primitive
  /// all of whose points are beyond one plane is not in the picture.
  unsigned outcode(const Vec3& p) const;
  /// Returns the depths of the part of a convex polygon in the picture (view coordinates).
  DepthInterval depths(std::span<const Vec3> polygon) const;
  /// Returns bounds of the depths of the part of a box in the picture (view coordinates). They are
  /// the box's own where it lies wholly in the picture, and never wider.
  DepthInterval depths(const Box3& box) const;

 private:
  static constexpr unsigned plane_count = 5;
  /// Returns how far within a plane the point lies, in units that differ from plane to plane.
  double height(unsigned plane, const Vec3& p) const;

  CameraFrame frame_;
  Projection projection_;
  Vec2 half_;  // of the picture, world units; perspective: at distance 1
};

}  // namespace pellucid::scene
