#include "groundtruth/composite.h"

#include <algorithm>
#include <cmath>

namespace pellucid {
namespace {

/// |n · v| for a two-sided surface; a normal without length gives 0.
double headlight(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& t, const Vec3& w,
                 const Vec3& ray_direction) {
  const Vec3 n = w.x * mesh.normals[t[0]] + w.y * mesh.normals[t[1]] + w.z * mesh.normals[t[2]];
  const double length = glm::length(n) * glm::length(ray_direction);
  return length > 0 ? std::abs(glm::dot(n, ray_direction)) / length : 0;
}

}  // namespace

Fragment shade(const Scene& scene, const Crossing& crossing, const Vec3& ray_direction) {
  const TriangleMesh& mesh = scene.objects[crossing.object].mesh();
  const auto& t = mesh.triangles[crossing.triangle];
  // Rounding may leave the first weight an ulp below 0, and the colour outside its hull.
  const Vec3 w(std::max(0.0, 1 - crossing.u - crossing.v), crossing.u, crossing.v);
  const glm::dvec4 rgba = w.x * glm::dvec4(mesh.colors[t[0]]) +
                          w.y * glm::dvec4(mesh.colors[t[1]]) + w.z * glm::dvec4(mesh.colors[t[2]]);
  Fragment fragment{Vec3(rgba), rgba.a};
  if (scene.lighting == Lighting::headlight) fragment.color *= headlight(mesh, t, w, ray_direction);
  return fragment;
}

Composite composite(const Scene& scene, std::span<const Crossing> crossings,
                    const Vec3& ray_direction) {
  Composite sum{Vec3(0), 1};
  for (const Crossing& crossing : crossings) {
    const Fragment fragment = shade(scene, crossing, ray_direction);
    sum.color += sum.transmittance * fragment.opacity * fragment.color;
    sum.transmittance *= 1 - fragment.opacity;
  }
  sum.color += sum.transmittance * scene.background;
  return sum;
}

}  // namespace pellucid
