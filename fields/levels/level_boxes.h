// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How boxes of levels lie to each other, for who looks for cells and pieces of a surface.

#include "fields/levels/level_field.h"

namespace pellucid::fields {

/// Returns whether a box lies in another one, whose faces it may touch.
inline bool is_inside(const Box3& part, const Box3& whole) {
  return whole.contains(part.min) && whole.contains(part.max);
}

/// Returns whether two boxes have a point in common, if only one of their faces'.
inline bool touch(const Box3& a, const Box3& b) {
  return glm::all(glm::lessThanEqual(a.min, b.max)) && glm::all(glm::lessThanEqual(b.min, a.max));
}

/// Returns the length, in world units, up to which faces of two levels count as one: where they are
/// meant to be, rounding puts them some ulp apart.
inline double face_rounding(const LevelField& field) { return 1e-8 * field.levels().front().width; }

/// Returns the box that touches all whose faces are meant to be those of `box`.
inline Box3 with_rounding(const LevelField& field, const Box3& box) {
  return {box.min - face_rounding(field), box.max + face_rounding(field)};
}

}  // namespace pellucid::fields
