// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/vertices.h"

namespace pellucid::scene {

/// A Transform scales along the world's axes about the origin, then turns about an axis through the
/// origin, then shifts.
struct Transform {
  Vec3 scale{1};        // not 0
  Vec3 axis{0, 0, 1};   // of any length but 0
  double degrees = 0;   // counterclockwise, seen from the axis' tip
  Vec3 translation{0};  // world units
};

/// Returns the matrix of the scale and the turn. A quarter turn's multiples about an axis of the
/// world are exact.
Mat3 linear_part(const Transform& transform);

/// Moves the vertices. Normals stay perpendicular to what they were; widths of lines and points
/// are in the world's units and stay. Throws InputError when a coordinate is no number below
/// geometry::coordinate_limit then.
void transform(const Transform& transform, geometry::Vertices& vertices);

}  // namespace pellucid::scene
