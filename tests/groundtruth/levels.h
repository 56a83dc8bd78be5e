#pragma once
// Fields on levels, and their exact crossings, for tests.

#include <algorithm>
#include <cmath>
#include <vector>

#include "fields/surface_cells.h"
#include "groundtruth/level_ray.h"

namespace pellucid {

template <class Function>
ScalarLevel sampled(const Vec3& origin, double width, int n, const Function& f) {
  ScalarLevel level{origin, width, {n, n, n}, {}};
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) level.samples.push_back(float(f(level.world(Vec3(i, j, k)))));
  return level;
}

/// [0, 8]³ in cells of 1, and [2, 6]³ in cells of a half.
template <class Function>
LevelField nested(const Function& f, const ReconstructionRow& row) {
  return LevelField({sampled(Vec3(0.5), 1, 8, f), sampled(Vec3(2.25), 0.5, 8, f)}, row);
}

inline double wavy(const Vec3& x) { return std::sin(1.3 * x.x) * std::cos(x.y) + 0.3 * x.z - 1; }

inline std::vector<double> exact_crossings(const LevelField& field, double value,
                                           const WorldRay& ray) {
  std::vector<double> at;
  for (const LatticeCell& cell : surface_cells(field, value))
    append_level_crossings(field, value, cell, ray, at);
  std::ranges::sort(at);
  return at;
}

}  // namespace pellucid
