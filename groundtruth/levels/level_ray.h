// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "fields/levels/level_field.h"

namespace pellucid::groundtruth {

/// A WorldRay runs over a field of levels: x(t) = start + t direction, in world coordinates.
struct WorldRay {
  Vec3 start, direction;
  Vec3 at(double t) const { return start + t * direction; }
};

/// Appends every t, ascending, at which the ray crosses the surface of `value` in the cell, where
/// the cell's level is the finest; only t ≥ 0.
void append_level_crossings(const fields::LevelField& field, double value,
                            const fields::LatticeCell& cell, const WorldRay& ray,
                            std::vector<double>& at);

}  // namespace pellucid::groundtruth
