// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Rays against balls and hulls of two balls, in double and close to the solid, whatever the
// distance of the eye.

#include <algorithm>
#include <cmath>
#include <optional>

#include "groundtruth/rays/eye_side.h"
#include "groundtruth/shapes/crossing_geometry.h"

namespace pellucid::groundtruth {

/// A LocalRay is a ray seen from a local origin: x(t) = offset + t direction, in units, t = 0 at
/// the point nearest to it. A small solid far away loses no digits but those that its own
/// coordinates have lost.
struct LocalRay {
  LocalRay(const SceneRay& ray, const Vec3& origin);

  Vec3 at(double t) const { return offset + t * direction; }
  double depth(double t) const { return nearest_depth + t * direction.z; }

  Vec3 offset, direction;
  double nearest_depth;  // view depth at t = 0, units
};

/// A Chord is the part of a ray within a convex solid, from t = begin to end, begin < end.
struct Chord {
  double begin, end;
};

/// A SolidEnd is where a ray crosses the surface of a ball or of a cone-sphere.
struct SolidEnd {
  double depth;   // view depth, units
  double along;   // of a cone-sphere: where the ball's centre lies that touches there, see below
  double cosine;  // n · v, n the outer normal, v the ray's direction
};

/// SolidEnds are where a ray enters a convex solid, and where it leaves it.
struct SolidEnds {
  SolidEnd enters, leaves;
};

/// Returns the depths of the two ends. Where rounding leaves in doubt on which side of the eye
/// one lies, `side()` is asked for eye_side().
template <class Side>
SolidDepths solid_depths(const SceneRay& ray, const SolidEnds& ends, const Side& side) {
  const SolidDepths depths{ends.enters.depth, ends.leaves.depth};
  if (std::min(std::abs(depths.enters), std::abs(depths.leaves)) >= ray.doubt.most) return depths;
  return with_signs_of(side(), depths);
}

/// Returns where the ray crosses the ball around `center`, in view coordinates, if it meets it.
/// Nothing but ray, centre and radius counts: whoever shares a ball gets the same bits.
std::optional<SolidEnds> ball_ends(const SceneRay& ray, const Vec3& center, double radius);

/// Returns where the ray crosses a cone-sphere, if it meets it: the convex hull of the balls a and
/// b, in view coordinates. That is what balls fill whose centres run from a's, at -1, to b's, at 1,
/// and whose radii are linear between theirs: the two balls and the frustum around which their
/// common tangents run, a cylinder where the radii are equal; the larger ball where it holds the
/// other. Each end is that of the part it lies on: a ball's is ball_ends(), the frustum's is the
/// same from a to b and from b to a.
std::optional<SolidEnds> cone_sphere_ends(const SceneRay& ray, const Ball& a, const Ball& b);

}  // namespace pellucid::groundtruth
