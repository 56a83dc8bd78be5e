// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/vec.h"

namespace pellucid::scene {

/// Returns the units per world length: the power of two that brings the box's largest half side
/// into (1/2, 1]. Scaling by it is exact but for underflow, makes results independent of the
/// scene's scale, and floats as fine as they can be. It is 1 for an empty box and a single point.
double unit_scale(const Box3& box);

/// Returns v times the power of two that brings its largest component into [1, 2): its digits are
/// those of v, and its square is a number whatever the length of v. 0 stays 0.
Vec3 with_unit_exponent(const Vec3& v);

/// Returns the unit vector of v's direction, whatever the length of v; 0 stays 0.
Vec3 normalized_or_zero(const Vec3& v);

}  // namespace pellucid::scene
