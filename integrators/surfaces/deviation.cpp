// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/surfaces/deviation.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/parallel.h"

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

std::vector<Deviation> search_all(std::size_t count, const Search& search) {
  constexpr std::size_t at_once = 64;
  std::vector<Deviation> deviations(count);
  parallel_for(std::size_t(0), count, [&](std::size_t i) { deviations[i] = search(i, false); });
  std::vector<std::size_t> largest_first(count);
  std::iota(largest_first.begin(), largest_first.end(), std::size_t(0));
  std::ranges::stable_sort(largest_first, std::greater(),
                           [&](std::size_t i) { return deviations[i].distance; });
  double largest = 0;
  for (std::size_t begin = 0; begin < count; begin += at_once) {
    if (deviations[largest_first[begin]].distance <= largest) break;
    const std::size_t end = std::min(begin + at_once, count);
    parallel_for(begin, end, [&](std::size_t k) {
      deviations[largest_first[k]] = search(largest_first[k], true);
    });
    for (std::size_t k = begin; k < end; ++k)
      largest = std::max(largest, deviations[largest_first[k]].distance);
  }
  return deviations;
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
