// SPDX-License-Identifier: GPL-3.0-or-later
#include <pellucid/rays.h>

#include <stdexcept>

#include "core/error.h"
#include "groundtruth/queries/ray_query.h"

namespace pellucid {

struct MeshRays::State {
  groundtruth::RayQuery query;
};

namespace {

Vec3 vector_of(const Point3& p) { return Vec3(p[0], p[1], p[2]); }

groundtruth::FreeRay ray_of(const Point3& origin, const Point3& direction) {
  return {vector_of(origin), vector_of(direction)};
}

RayCrossing crossing_of(const groundtruth::RayHit& hit) {
  return {hit.t, hit.u, hit.v, hit.triangle, hit.side};
}

/// Calls what may throw our error, which no public header names.
template <class Call>
auto with_public_error(const Call& call) {
  try {
    return call();
  } catch (const InputError& error) {
    throw std::invalid_argument(error.what());
  }
}

geometry::TriangleMesh mesh_of(std::span<const Point3> vertices,
                               std::span<const std::array<std::uint32_t, 3>> triangles) {
  geometry::TriangleMesh mesh;
  mesh.positions.reserve(vertices.size());
  for (const Point3& x : vertices) mesh.positions.push_back(vector_of(x));
  mesh.triangles.assign(triangles.begin(), triangles.end());
  return mesh;
}

}  // namespace

MeshRays::MeshRays(std::span<const Point3> vertices,
                   std::span<const std::array<std::uint32_t, 3>> triangles)
    : state_(with_public_error([&] {
        return std::make_unique<State>(State{groundtruth::RayQuery(mesh_of(vertices, triangles))});
      })) {}

MeshRays::~MeshRays() = default;
MeshRays::MeshRays(MeshRays&&) noexcept = default;
MeshRays& MeshRays::operator=(MeshRays&&) noexcept = default;

std::vector<RayCrossing> MeshRays::all(const Point3& origin, const Point3& direction) const {
  return with_public_error([&] {
    std::vector<RayCrossing> crossings;
    for (const groundtruth::RayHit& hit : state_->query.all(ray_of(origin, direction)))
      crossings.push_back(crossing_of(hit));
    return crossings;
  });
}

std::optional<RayCrossing> MeshRays::first(const Point3& origin, const Point3& direction) const {
  return with_public_error([&]() -> std::optional<RayCrossing> {
    const auto hit = state_->query.first(ray_of(origin, direction));
    if (!hit) return std::nullopt;
    return crossing_of(*hit);
  });
}

std::size_t MeshRays::count(const Point3& origin, const Point3& direction) const {
  return with_public_error([&] { return state_->query.count(ray_of(origin, direction)); });
}

bool MeshRays::inside(const Point3& point) const {
  return with_public_error([&] { return state_->query.inside(vector_of(point)); });
}

}  // namespace pellucid
