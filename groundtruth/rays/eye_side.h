// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Does a ray begin within a round solid, on it or outside?

#include "groundtruth/rays/view_frame.h"

namespace pellucid::groundtruth {

/// A Ball is all within a radius of its centre.
struct Ball {
  Vec3 center;
  double radius;
};

/// Returns -1 where the ray's point at depth 0, the eye of a perspective camera, lies within the
/// convex hull of two balls, 0 where it lies on its surface, else 1: of the world's coordinates,
/// without rounding. Centres are in the world, radii in units of the frame.
int eye_side(const ViewFrame& frame, const PictureRay& ray, const Ball& a, const Ball& b);

/// The depths at which a ray enters and leaves a convex solid.
struct SolidDepths {
  double enters, leaves;
};

/// Returns the depths with the signs that the side of the eye demands, where rounding has left them
/// in doubt: an end that lies at the eye is 0 exactly.
SolidDepths with_signs_of(int eye_side, SolidDepths depths);

}  // namespace pellucid::groundtruth
