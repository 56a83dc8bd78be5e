// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/vec.h"

namespace pellucid::integrators {

/// A SeedCurve is where particles start: a curve c(s), s in [0, 1], in world units. On a closed
/// curve c(0) = c(1). A value; made by one of the functions below.
struct SeedCurve {
  bool closed = false;
  std::function<Vec3(double s)> point_at;
  std::function<Vec3(double s)> tangent_at;  // dc/ds; at a corner that of the piece after it
  std::vector<double> corners;               // s in [0, 1) where the tangent turns, ascending
};

/// Makes the straight segment between two points, s proportional to arc length.
SeedCurve segment_seed(const Vec3& from, const Vec3& to);

/// Makes a polyline, s proportional to arc length. Repeated points are dropped. Throws InputError
/// when a point is not finite or fewer than two differ.
SeedCurve polyline_seed(std::span<const Vec3> points, bool closed = false);

/// Makes the closed circle about `center` in the plane across `normal`; world units.
SeedCurve circle_seed(const Vec3& center, const Vec3& normal, double radius);

/// Makes a C¹ curve through the points: Catmull-Rom with centripetal knots.
SeedCurve spline_seed(std::span<const Vec3> points, bool closed = false);

/// Makes a seed of any curve that is smooth on [0, 1]; its tangent is differenced unless given.
SeedCurve callable_seed(std::function<Vec3(double)> point, bool closed = false,
                        std::function<Vec3(double)> tangent = {});

}  // namespace pellucid::integrators
