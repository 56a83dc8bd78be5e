// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where the samples of the grid files lie, and what is there, for all who write them.

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "tests/fields/readers/grid_files.h"

namespace pellucid::fields {

using Positions = std::vector<Vec3>;

inline constexpr std::array<int, 3> grid_size = {5, 6, 7};

/// Position of a sample along an axis; `warp` bends the spacing but keeps the ends.
inline double along(int axis, int i, double warp) {
  const double s = double(i) / (grid_size[axis] - 1);
  return glm::mix(grid_box.min[axis], grid_box.max[axis], s + warp * s * (1 - s));
}

/// Between samples of an axis that is not warped.
inline double step(int axis) { return along(axis, 1, 0) - along(axis, 0, 0); }

inline Positions rectilinear(double warp) {
  Positions positions;
  for (int k = 0; k < grid_size[2]; ++k)
    for (int j = 0; j < grid_size[1]; ++j)
      for (int i = 0; i < grid_size[0]; ++i)
        positions.emplace_back(along(0, i, warp), along(1, j, warp), along(2, k, warp));
  return positions;
}

/// Inner points are moved about, so that cells are general hexahedra; the box stays.
inline Positions curvilinear() {
  Positions positions = rectilinear(0.2);
  for (Vec3& x : positions) {
    const Vec3 s = (x - grid_box.min) / (grid_box.max - grid_box.min);
    const Vec3 inside = s * (1.0 - s);
    x += 2.0 * inside.x * inside.y * inside.z * Vec3(1, -0.7, 0.5) * std::sin(9 * s.x + 5 * s.z);
  }
  return positions;
}

inline Positions evaluate(const Positions& positions, const Velocity& velocity) {
  Positions vectors;
  for (const Vec3& x : positions) vectors.push_back(velocity(x));
  return vectors;
}

template <class T>
std::string native_bytes(const Positions& vectors) {
  std::string bytes;
  for (const Vec3& v : vectors)
    for (int c = 0; c < 3; ++c) {
      const T number = T(v[c]);
      bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
    }
  return bytes;
}

}  // namespace pellucid::fields
