// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/vec.h"

namespace pellucid::compare {

/// Returns the distance from `point` to the convex hull of `points` (at least one), 0 inside, by
/// Gilbert, Johnson and Keerthi 1988, "A fast procedure for computing the distance between complex
/// objects in three-dimensional space", IEEE J. Robotics and Automation 4(2): a simplex of hull
/// points is improved until no point lies beyond it. It errs by up to 1e-7 for coordinates of about
/// 1, but for hulls that are nearly flat, whose thin simplices are passed over: there 2.4e-5 was
/// seen in two million pixels.
double hull_distance(const Vec3& point, std::span<const Vec3> points);

}  // namespace pellucid::compare
