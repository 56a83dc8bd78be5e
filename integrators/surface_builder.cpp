#include "integrators/surface_builder.h"

#include <cmath>

namespace pellucid {
namespace {

// Memory that is reserved and not written to has no pages: ample arrays cost nothing, where arrays
// that double were 20 % of a surface's time in copies and page faults.
constexpr std::size_t first_capacity = 1 << 18;
constexpr std::size_t growth = 4;

}  // namespace

SurfaceBuilder::SurfaceBuilder(double start_time, bool with_normals)
    : start_time_(start_time), with_normals_(with_normals) {
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
  s_.push_back(s > 1 ? s - std::floor(s) : s);
  t_.push_back(point.t);
  speed_.push_back(point.speed);
  return std::uint32_t(positions_.size() - 1);
}

void SurfaceBuilder::add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  if (triangles_.size() == triangles_.capacity())
    triangles_.reserve(growth * triangles_.capacity());
  triangles_.push_back({a, b, c});
}

/// Of what is written: pages that are only reserved do not exist.
std::uint64_t SurfaceBuilder::bytes() const {
  return (positions_.size() + normals_.size()) * sizeof(Vec3) +
         (s_.size() + t_.size() + speed_.size()) * sizeof(double) +
         triangles_.size() * sizeof(triangles_[0]);
}

/// Where the flow has no normal, that of the triangles around stands in.
void SurfaceBuilder::fill_missing_normals() {
  std::vector<bool> missing(normals_.size());
  for (std::size_t i = 0; i < normals_.size(); ++i) missing[i] = normals_[i] == Vec3(0);
  for (const auto& [a, b, c] : triangles_) {
    if (!missing[a] && !missing[b] && !missing[c]) continue;
    const Vec3 area = glm::cross(positions_[b] - positions_[a], positions_[c] - positions_[a]);
    for (const std::uint32_t corner : {a, b, c})
      if (missing[corner]) normals_[corner] += area;
  }
  for (std::size_t i = 0; i < normals_.size(); ++i) {
    if (!missing[i]) continue;
    const double length = glm::length(normals_[i]);
    normals_[i] = length > 0 ? normals_[i] / length : Vec3(0, 0, 1);
  }
}

TriangleMesh SurfaceBuilder::finish() {
  if (with_normals_) fill_missing_normals();
  TriangleMesh mesh;
  auto& time = mesh.scalars["time"] = t_;
  for (double& t : time) t += start_time_;
  mesh.positions = std::move(positions_);
  mesh.normals = std::move(normals_);
  mesh.scalars["s"] = std::move(s_);
  mesh.scalars["t"] = std::move(t_);
  mesh.scalars["speed"] = std::move(speed_);
  mesh.triangles = std::move(triangles_);
  return mesh;
}

}  // namespace pellucid
