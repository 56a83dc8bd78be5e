// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/vertices.h"

namespace pellucid::geometry {

/// A TriangleMesh is a triangle soup with shared vertices, as it is drawn; each triangle holds
/// three indices of vertices, from 0.
struct TriangleMesh : Vertices {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  /// Holds one value per triangle, by name: what a file says of its faces or cells.
  std::map<std::string, std::vector<double>> face_scalars;
};

}  // namespace pellucid::geometry
