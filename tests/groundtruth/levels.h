// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A field on levels, and exact crossings, for tests.

#include <algorithm>
#include <cmath>
#include <vector>

#include "fields/levels/surface_cells.h"
#include "groundtruth/levels/level_ray.h"
#include "tests/support/levels.h"

namespace pellucid::groundtruth {

using testing::sampled;

/// [0, 8]³ in cells of 1, and [2, 6]³ in cells of a half.
template <class Function>
fields::LevelField nested(const Function& f, const fields::ReconstructionRow& row) {
  return fields::LevelField(testing::nested(f), row);
}

inline double wavy(const Vec3& x) { return std::sin(1.3 * x.x) * std::cos(x.y) + 0.3 * x.z - 1; }

inline std::vector<double> exact_crossings(const fields::LevelField& field, double value,
                                           const WorldRay& ray) {
  std::vector<double> at;
  for (const fields::LatticeCell& cell : fields::surface_cells(field, value))
    append_level_crossings(field, value, cell, ray, at);
  std::ranges::sort(at);
  return at;
}

}  // namespace pellucid::groundtruth
