// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/vec.h"

namespace pellucid::testing {

/// Returns the area of what has `positions` and `triangles`, in their unit squared.
template <class Mesh>
double area_of(const Mesh& mesh) {
  double area = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    area += 0.5 * glm::length(glm::cross(Vec3(mesh.positions[b] - mesh.positions[a]),
                                         Vec3(mesh.positions[c] - mesh.positions[a])));
  return area;
}

}  // namespace pellucid::testing
