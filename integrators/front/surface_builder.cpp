// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/front/surface_builder.h"

#include <cmath>

#include "integrators/mesh/missing_normals.h"

namespace pellucid::integrators {
namespace {

// Memory that is reserved and not written to has no pages: ample arrays cost nothing, where arrays
// that double were 20 % of a surface's time in copies and page faults.
constexpr std::size_t first_capacity = 1 << 18;
constexpr std::size_t growth = 4;

}  // namespace

SurfaceBuilder::SurfaceBuilder(const SurfaceRequest& request, bool with_normals)
    : start_time_(request.start_time),
      path_(request.path),
      with_normals_(with_normals),
      curve_(request.seed) {
  reserve_vertices(first_capacity);
  triangles_.reserve(2 * first_capacity);
}

void SurfaceBuilder::reserve_vertices(std::size_t count) {
  positions_.reserve(count);
  if (with_normals_) normals_.reserve(count);
  for (auto* scalars : {&s_, &t_, &speed_}) scalars->reserve(count);
}

std::uint32_t SurfaceBuilder::add_vertex(const FrontPoint& point, double s) {
  if (positions_.size() == positions_.capacity()) reserve_vertices(growth * positions_.capacity());
  positions_.push_back(point.flow.x);
  if (with_normals_) normals_.push_back(point.normal);
  s_.push_back(s > 1 || s < 0 ? s - std::floor(s) : s);
  t_.push_back(point.t);
  speed_.push_back(point.speed);
  return std::uint32_t(positions_.size() - 1);
}

void SurfaceBuilder::add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  if (triangles_.size() == triangles_.capacity())
    triangles_.reserve(growth * triangles_.capacity());
  triangles_.push_back({a, b, c});
}

bool SurfaceBuilder::has_one_normal(std::uint32_t vertex) const {
  return normals_[vertex] != Vec3(0);
}

/// From a to b; over the seam of a closed curve s jumps from 1 to 0.
double SurfaceBuilder::s_step(std::uint32_t a, std::uint32_t b) const {
  const double step = s_[b] - s_[a];
  return curve_.closed ? step - std::round(step) : step;
}

double SurfaceBuilder::parameter_area(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
  return s_step(a, b) * (t_[c] - t_[a]) - s_step(a, c) * (t_[b] - t_[a]);
}

std::pair<double, double> SurfaceBuilder::halfway(std::uint32_t a, std::uint32_t b) const {
  return {s_[a] + 0.5 * s_step(a, b), 0.5 * (t_[a] + t_[b])};
}

/// Of what is written: pages that are only reserved do not exist.
std::uint64_t SurfaceBuilder::bytes() const {
  return (positions_.size() + normals_.size()) * sizeof(Vec3) +
         (s_.size() + t_.size() + speed_.size()) * sizeof(double) +
         triangles_.size() * sizeof(triangles_[0]);
}

void SurfaceBuilder::drop_unused_vertices() {
  constexpr std::uint32_t unused = ~0u;
  std::vector<std::uint32_t> place(vertex_count(), unused);
  for (const auto& triangle : triangles_)
    for (const std::uint32_t corner : triangle) place[corner] = 0;
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < place.size(); ++i) {
    if (place[i] == unused) continue;
    positions_[count] = positions_[i];
    if (with_normals_) normals_[count] = normals_[i];
    for (auto* scalars : {&s_, &t_, &speed_}) (*scalars)[count] = (*scalars)[i];
    place[i] = count++;
  }
  positions_.resize(count);
  if (with_normals_) normals_.resize(count);
  for (auto* scalars : {&s_, &t_, &speed_}) scalars->resize(count);
  for (auto& triangle : triangles_)
    for (std::uint32_t& corner : triangle) corner = place[corner];
}

geometry::TriangleMesh SurfaceBuilder::finish() {
  if (with_normals_) fill_missing_normals(positions_, triangles_, normals_);
  geometry::TriangleMesh mesh;
  auto& time = mesh.scalars["time"] = t_;
  // The field's time, at which attributes are looked up, too: on a stream surface it stands still.
  for (double& t : time) t = start_time_ + (path_ ? t : 0);
  mesh.positions = std::move(positions_);
  mesh.normals = std::move(normals_);
  mesh.scalars["s"] = std::move(s_);
  mesh.scalars["t"] = std::move(t_);
  mesh.scalars["speed"] = std::move(speed_);
  mesh.triangles = std::move(triangles_);
  return mesh;
}

}  // namespace pellucid::integrators
