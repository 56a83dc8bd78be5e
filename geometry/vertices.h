// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/vec.h"

namespace pellucid::geometry {

/// Coordinates and radii are below it, so that their sums and differences are numbers.
constexpr double coordinate_limit = 1e300;

/// Vertices are points in world units and what they carry, whatever joins them. Arrays are empty or
/// as long as `positions`; values are interpolated linearly between joined vertices.
struct Vertices {
  std::vector<Vec3> positions;  // world
  std::vector<Vec3> normals;    // unit length, world; either side
  std::vector<Rgba> colors;     // straight (not premultiplied) colour, opacity in alpha, in [0, 1]
  std::vector<float> importance;                       // g in [0, 1]
  std::map<std::string, std::vector<double>> scalars;  // by name: s, t, time, speed, …
  std::vector<std::string> remarks;  // what of their file was mended or is not drawn, a line each

  Box3 bounds() const {
    Box3 box;
    for (const Vec3& x : positions) box.extend(x);
    return box;
  }
};

}  // namespace pellucid::geometry
