// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "fields/field.h"
#include "fields/files/quantity.h"

namespace pellucid::fields {

/// A Plane goes through `origin`, in world units, across the unit vector `normal`. What is within
/// `slack` of it counts as on it: positions are rounded.
struct Plane {
  Vec3 origin{0}, normal{0, 0, 1};
  double slack = 0;

  /// Returns how far x is from the plane, in world units; below 0 on the normal's other side.
  double distance(const Vec3& x) const { return glm::dot(x - origin, normal); }
  Vec3 onto(const Vec3& x) const { return x - distance(x) * normal; }
};

/// Makes a field on a plane of `field`, which has a velocity on both sides of it: that of the
/// nearest point of the plane, of a velocity without its part across the plane. Off the plane it is
/// `outside`. `bounds` is the box of the plane's part that has samples.
std::unique_ptr<VectorField> make_planar_field(std::unique_ptr<VectorField> field,
                                               const Plane& plane, const Box3& bounds,
                                               Quantity quantity);

}  // namespace pellucid::fields
