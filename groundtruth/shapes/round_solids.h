// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Rays against balls and round cylinders, in double and close to the solid, whatever the distance
// of the eye.

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

/// Returns the depths of the chord's ends. Where rounding leaves in doubt on which side of the eye
/// one lies, `side()` is asked for eye_side().
template <class Side>
SolidDepths solid_depths(const SceneRay& ray, const LocalRay& local, const Chord& chord,
                         const Side& side) {
  const SolidDepths depths{local.depth(chord.begin), local.depth(chord.end)};
  if (std::min(std::abs(depths.enters), std::abs(depths.leaves)) >= ray.doubt.most) return depths;
  return with_signs_of(side(), depths);
}

/// Returns the ray's chord in a ball, if it meets it; `center` is relative to the ray's origin.
std::optional<Chord> ball_chord(const LocalRay& ray, const Vec3& center, double radius);

/// Returns the ray's chord in a capsule, if it meets it: all within `radius` of the segment from
/// -half to +half, relative to the ray's origin; a cylinder and the balls at its ends.
std::optional<Chord> capsule_chord(const LocalRay& ray, const Vec3& half, double radius);

}  // namespace pellucid::groundtruth
