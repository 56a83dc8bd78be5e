// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/mesh/missing_normals.h"

#include <cmath>
#include <vector>

#include "integrators/paths/magnitude.h"

namespace pellucid::integrators {

void fill_missing_normals(std::span<const Vec3> positions,
                          std::span<const std::array<std::uint32_t, 3>> triangles,
                          std::span<Vec3> normals) {
  std::vector<bool> missing(normals.size());
  for (std::size_t i = 0; i < normals.size(); ++i) missing[i] = normals[i] == Vec3(0);
  for (const auto& [a, b, c] : triangles) {
    if (!missing[a] && !missing[b] && !missing[c]) continue;
    const std::array corners{a, b, c};
    for (std::size_t k = 0; k < 3; ++k) {
      if (!missing[corners[k]]) continue;
      const Vec3& x = positions[corners[k]];
      const Vec3 one = positions[corners[(k + 1) % 3]] - x;
      const Vec3 other = positions[corners[(k + 2) % 3]] - x;
      const Vec3 area = glm::cross(one, other);
      normals[corners[k]] += std::atan2(magnitude(area), glm::dot(one, other)) * direction_of(area);
    }
  }
  for (std::size_t i = 0; i < normals.size(); ++i) {
    if (!missing[i]) continue;
    const double length = glm::length(normals[i]);
    normals[i] = length > 0 ? normals[i] / length : Vec3(0, 0, 1);
  }
}

}  // namespace pellucid::integrators
