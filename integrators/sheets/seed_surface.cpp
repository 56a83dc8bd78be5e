// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/sheets/seed_surface.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <tuple>

#include "core/error.h"
#include "integrators/mesh/facet_normal.h"

namespace pellucid::integrators {
namespace {

bool all_finite(const Vec3& x) {
  return std::isfinite(x.x) && std::isfinite(x.y) && std::isfinite(x.z);
}

/// The twelve vertices are (0, ±1, ±φ) and its turns; the sphere's places are on this icosahedron.
void add_icosahedron(SeedSurface& seed) {
  constexpr double phi = 1.6180339887498948482;
  seed.places = {{-1, phi, 0}, {1, phi, 0}, {-1, -phi, 0}, {1, -phi, 0},
                 {0, -1, phi}, {0, 1, phi}, {0, -1, -phi}, {0, 1, -phi},
                 {phi, 0, -1}, {phi, 0, 1}, {-phi, 0, -1}, {-phi, 0, 1}};
  seed.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                    {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                    {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                    {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
}

/// Numbers positions, equal ones alike.
class Places {
 public:
  explicit Places(std::vector<Vec3>& places) : places_(places) {}

  std::uint32_t number(const Vec3& x) {
    const auto [found, is_new] =
        numbers_.try_emplace({x.x, x.y, x.z}, std::uint32_t(places_.size()));
    if (is_new) places_.push_back(x);
    return found->second;
  }

 private:
  std::vector<Vec3>& places_;
  std::map<std::tuple<double, double, double>, std::uint32_t> numbers_;
};

}  // namespace

SeedSurface patch_seed(const Vec3& corner, const Vec3& u, const Vec3& v) {
  if (!all_finite(corner) || !all_finite(u) || !all_finite(v) || !has_area(Vec3(0), u, v))
    throw InputError("seed patch: accepted: finite numbers, u and v that span an area");
  SeedSurface seed;
  seed.places = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  seed.triangles = {{0, 1, 2}, {0, 2, 3}};
  seed.is_square = true;
  seed.point_at = [=](const Vec3& place) { return corner + place.x * u + place.y * v; };
  seed.tangent_at = [=](const Vec3&, const Vec3& step) { return step.x * u + step.y * v; };
  seed.normal_at = [n = direction_of(facet_sine(Vec3(0), u, v))](const Vec3&) { return n; };
  return seed;
}

SeedSurface sphere_seed(const Vec3& center, double radius) {
  if (!all_finite(center) || !(radius > 0) || !std::isfinite(radius))
    throw InputError(
        fmt::format("seed sphere: radius {}; accepted: a finite centre, a radius above 0", radius));
  SeedSurface seed;
  add_icosahedron(seed);
  seed.point_at = [=](const Vec3& place) { return center + radius * direction_of(place); };
  seed.tangent_at = [=](const Vec3& place, const Vec3& step) {
    const Vec3 n = direction_of(place);
    return radius / glm::length(place) * (step - glm::dot(step, n) * n);
  };
  seed.normal_at = [](const Vec3& place) { return direction_of(place); };
  return seed;
}

SeedSurface mesh_seed(const geometry::TriangleMesh& mesh) {
  SeedSurface seed;
  Places places(seed.places);
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 &x = mesh.positions[a], &y = mesh.positions[b], &z = mesh.positions[c];
    if (!all_finite(x) || !all_finite(y) || !all_finite(z))
      throw InputError("seed mesh: a position is not finite");
    if (has_area(x, y, z))
      seed.triangles.push_back({places.number(x), places.number(y), places.number(z)});
  }
  if (seed.triangles.empty()) throw InputError("seed mesh: no triangle of it has an area");
  seed.creased = true;
  seed.point_at = [](const Vec3& place) { return place; };
  seed.tangent_at = [](const Vec3&, const Vec3& step) { return step; };
  seed.normal_at = [](const Vec3&) { return Vec3(0); };
  return seed;
}

}  // namespace pellucid::integrators
