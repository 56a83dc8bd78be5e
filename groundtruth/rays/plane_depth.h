// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How far along a ray lies a flat shape, whatever its vertices are called?

#include <array>
#include <tuple>

#include "groundtruth/rays/view_frame.h"

namespace pellucid::groundtruth {

/// Orders points by their coordinates: what is computed from points in this order is the same to
/// the last bit whichever of them is stored first.
inline bool in_coordinate_order(const Vec3& p, const Vec3& q) {
  return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
}

/// A FlatTriangle is one that a ray crosses: its corners in the world, and as they were rounded to
/// view coordinates.
struct FlatTriangle {
  std::array<Vec3, 3> world, view;
};

/// Returns the view depth, in units, at which the ray meets the triangle's plane: the exact depth,
/// rounded once to the nearest double. So it does not depend on the order of the corners, triangles
/// of one plane have one depth, and it is 0 where the eye lies in the plane. It is that of the
/// corners in the world, of the camera's frame as it was rounded; of a triangle that is seen within
/// 2^-14 of edge-on it is that of its corners as they were rounded to view coordinates, since they
/// decided that it is crossed. With the ray in its plane it is its centre's.
double plane_depth(const ViewFrame& frame, const PictureRay& ray, const FlatTriangle& triangle);

/// Returns the same of corners that exist in view coordinates alone.
double view_plane_depth(const PictureRay& ray, const std::array<Vec3, 3>& corners);

/// Returns the view depth of a point of the world, in units, rounded once.
double point_depth(const ViewFrame& frame, const Vec3& x);

/// A DepthDoubt says what the depths of a ray's crossings, as double computes them, leave open.
struct DepthDoubt {
  double most = 0;      // crossings further apart than this are in the order of their exact depths
  double rounding = 0;  // a bound on what rounding moves a vertex, and the ray beside it
};

/// Returns the doubt of a ray: no vertex has a coordinate larger than `largest` in view
/// coordinates.
DepthDoubt depth_doubt(const PictureRay& ray, double largest);

/// Returns a bound on the error of the depth of one crossing, as to_crossing() computes it, against
/// plane_depth() and view_plane_depth(): mostly far less than half the ray's doubt. `edge_bound` is
/// RayPredicate::bound(), the corners are in view coordinates.
double depth_error(const PictureRay& ray, const DepthDoubt& doubt, double edge_bound,
                   const std::array<Vec3, 3>& corners);

}  // namespace pellucid::groundtruth
