// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "oit/shapes/view_space.h"

namespace pellucid::oit {

/// A ConeSphere is the convex hull of the balls around a and b; view units, see
/// ViewSpace::view_position(). A sphere is one whose ends are the same.
struct ConeSphere {
  Vec3 a, b;
  double radius_a, radius_b;
};

/// A PictureRectangle is the part of the picture between bounds along two axes: the unit vector
/// `axis` and what lies to the left of it. Coordinates are what clip_scale takes to clip space:
/// view units at a view depth of 1 (perspective), or at any (orthographic), y up.
struct PictureRectangle {
  Vec2 first{0}, second{0};  // from and to, along the axes
  Vec2 axis{1, 0};

  bool empty() const { return !(first.x < first.y && second.x < second.y); }
};

/// Returns a rectangle that holds every pixel's centre, or other sample, whose ray meets the
/// solid in front of the eye, and not much more: its sides touch what is seen of the ends, an
/// eighth of a pixel farther out for what rasterization rounds. It reaches no farther than the
/// picture does, and is empty where the solid lies beside or behind.
PictureRectangle bounds_in_picture(const ConeSphere& solid, const ViewSpace& view);
/// Returns likewise a rectangle around a box of these corners.
PictureRectangle bounds_in_picture(const std::array<Vec3, 8>& corners, const ViewSpace& view);

}  // namespace pellucid::oit
