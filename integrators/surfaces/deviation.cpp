// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/surfaces/deviation.h"

#include <algorithm>
#include <cmath>

namespace pellucid::integrators {
namespace {

constexpr double degrees_per_radian = 57.295779513082320877;

std::vector<double> spread_to_vertices(const geometry::TriangleMesh& mesh,
                                       std::span<const MeshSample> samples,
                                       const std::vector<Deviation>& deviations) {
  std::vector<double> values(mesh.positions.size());
  double distance = 0;
  for (std::size_t triangle = 0, i = 0; triangle < mesh.triangles.size(); ++triangle) {
    if (i < samples.size() && samples[i].triangle == triangle) distance = 0;
    for (; i < samples.size() && samples[i].triangle == triangle; ++i)
      distance = std::max(distance, deviations[i].distance);
    for (const std::uint32_t corner : mesh.triangles[triangle])
      values[corner] = std::max(values[corner], distance);
  }
  return values;
}

}  // namespace

double degrees_between(const Vec3& a, const Vec3& b) {
  return degrees_per_radian * std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

SurfaceError surface_error(const geometry::TriangleMesh& mesh, std::span<const MeshSample> samples,
                           const std::vector<Deviation>& deviations) {
  SurfaceError error;
  error.samples = deviations.size();
  for (std::size_t i = 0; i < deviations.size(); ++i) {
    const auto& [distance, angle] = deviations[i];
    error.mean += samples[i].weight * distance;
    error.rms += samples[i].weight * distance * distance;
    error.max = std::max(error.max, distance);
    error.normal_mean_degrees += samples[i].weight * angle;
    error.normal_max_degrees = std::max(error.normal_max_degrees, angle);
  }
  error.rms = std::sqrt(error.rms);
  error.at_vertices = spread_to_vertices(mesh, samples, deviations);
  return error;
}

}  // namespace pellucid::integrators
