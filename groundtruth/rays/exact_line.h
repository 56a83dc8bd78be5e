// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Rays in the world, in any kind of number.

#include "groundtruth/rays/exact_number.h"
#include "groundtruth/rays/view_frame.h"

namespace pellucid::groundtruth {

/// A Line runs through origin + t · direction.
template <class Number>
struct Line {
  Triple<Number> origin, direction;
};

/// Returns from + x · right + y · up.
template <class Number>
Triple<Number> across_picture(const Vec3& from, const scene::CameraFrame& frame, double x,
                              double y) {
  Triple<Number> sum = triple<Number>(from);
  for (int i = 0; i < 3; ++i)
    sum[i] = sum[i] + Number(x) * Number(frame.right[i]) + Number(y) * Number(frame.up[i]);
  return sum;
}

/// Returns the ray in the world, as the camera's frame has been rounded; t is the view depth in
/// world units. `units_per_length` is that of the ray's frame.
template <class Number>
Line<Number> line(const scene::CameraFrame& frame, const PictureRay& ray, double units_per_length) {
  if (ray.projection == scene::Projection::perspective)
    return {triple<Number>(frame.eye), across_picture<Number>(frame.forward, frame, ray.x, ray.y)};
  return {
      across_picture<Number>(frame.eye, frame, ray.x / units_per_length, ray.y / units_per_length),
      triple<Number>(frame.forward)};
}

}  // namespace pellucid::groundtruth
