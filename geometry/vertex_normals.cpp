// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/vertex_normals.h"

#include <algorithm>
#include <cmath>

namespace pellucid::geometry {
namespace {

double largest_component(const Vec3& v) {
  const Vec3 size = glm::abs(v);
  return std::max({size.x, size.y, size.z});
}

/// The power of two that brings a size to 1 … 2, so that squares neither overflow nor vanish and
/// what is multiplied by it rounds as it would have; 1 of what is not above 0 or not finite.
double scale_of(double size) {
  if (!(size > 0) || !std::isfinite(size)) return 1;
  return std::ldexp(1.0, std::min(-std::ilogb(size), 1000));
}

bool is_none(const Vec3& n) {
  const bool finite = std::isfinite(n.x) && std::isfinite(n.y) && std::isfinite(n.z);
  return !finite || n == Vec3(0);
}

Vec3 unit(const Vec3& v) {
  const Vec3 scaled = v * scale_of(largest_component(v));
  return scaled / glm::length(scaled);
}

}  // namespace

std::vector<Vec3> facet_normals(const TriangleMesh& mesh) {
  std::vector<Vec3> normals(mesh.positions.size(), Vec3(0));
  const Box3 box = mesh.bounds();
  const double scale = scale_of(largest_component(box.max - box.min));
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 one = mesh.positions[b] - mesh.positions[a];
    const Vec3 other = mesh.positions[c] - mesh.positions[a];
    const Vec3 area = glm::cross(scale * one, scale * other);
    for (const std::uint32_t v : {a, b, c}) normals[v] += area;
  }
  for (Vec3& n : normals) n = is_none(n) ? Vec3(0, 0, 1) : unit(n);
  return normals;
}

void make_unit(std::vector<Vec3>& normals) {
  for (Vec3& n : normals) n = is_none(n) ? Vec3(0) : unit(n);
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
