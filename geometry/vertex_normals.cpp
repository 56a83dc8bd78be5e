// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/vertex_normals.h"

#include <algorithm>
#include <cmath>

namespace pellucid::geometry {
namespace {

bool is_none(const Vec3& normal) {
  const double length = glm::length(normal);
  return !(length > 0) || !std::isfinite(length);
}

}  // namespace

std::vector<Vec3> facet_normals(const TriangleMesh& mesh) {
  std::vector<Vec3> normals(mesh.positions.size(), Vec3(0));
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 area =
        glm::cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
    for (const std::uint32_t v : {a, b, c}) normals[v] += area;
  }
  for (Vec3& n : normals) {
    const double length = glm::length(n);
    n = length > 0 ? n / length : Vec3(0, 0, 1);
  }
  return normals;
}

void make_unit(std::vector<Vec3>& normals) {
  for (Vec3& n : normals) n = is_none(n) ? Vec3(0) : n / glm::length(n);
}

std::size_t mend_normals(TriangleMesh& mesh) {
  make_unit(mesh.normals);
  const auto none = std::size_t(std::ranges::count_if(mesh.normals, is_none));
  if (none == mesh.normals.size()) {
    mesh.normals.clear();
  } else if (none > 0) {
    const std::vector<Vec3> facets = facet_normals(mesh);
    for (std::size_t i = 0; i < facets.size(); ++i)
      if (is_none(mesh.normals[i])) mesh.normals[i] = facets[i];
  }
  return none;
}

}  // namespace pellucid::geometry
