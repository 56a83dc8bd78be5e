// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/surfaces/surface_error.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/parallel.h"
#include "integrators/front/surface_particles.h"
#include "integrators/mesh/mesh_distance.h"
#include "integrators/mesh/mesh_samples.h"

namespace pellucid::integrators {
namespace {

constexpr double degrees = 57.295779513082320877;

/// A point of the mesh with its parameters on the surface.
struct Sample {
  double s, t;
  Vec3 x, facet;  // facet: unit normal
};

struct Deviation {
  double distance = 0, degrees = 0;
};

Sample sample_of(const geometry::TriangleMesh& mesh, const MeshSample& place, bool closed) {
  const auto& corners = mesh.triangles[place.triangle];
  const auto &s = mesh.scalars.at("s"), &t = mesh.scalars.at("t");
  const double first = s[corners[0]];
  Sample sample{0, 0, position_of(mesh, place), Vec3(0)};
  for (std::size_t k = 0; k < 3; ++k) {
    // Over the seam of a closed curve s jumps from 1 to 0.
    const double turn = closed ? std::round(first - s[corners[k]]) : 0;
    sample.s += place.barycentric[k] * (s[corners[k]] + turn);
    sample.t += place.barycentric[k] * std::abs(t[corners[k]]);  // below 0 on the way back
  }
  const Vec3& x = mesh.positions[corners[0]];
  const Vec3 area = glm::cross(mesh.positions[corners[1]] - x, mesh.positions[corners[2]] - x);
  const double length = glm::length(area);
  sample.facet = length > 0 ? area / length : Vec3(0);
  return sample;
}

class ExactSurface {
 public:
  ExactSurface(const SurfaceRequest& request, const SurfaceSetup& setup)
      : request_(request), source_(request, setup) {}

  Deviation deviation(Sample sample);
  /// Points of the surface at seed s, spread over the particle's time.
  std::vector<Vec3> points_at(double s);

 private:
  FlowPoint point(double s, double& t);

  const SurfaceRequest& request_;
  ParticleSource source_;
};

/// Where the surface ends before t, its last point: t is set back.
FlowPoint ExactSurface::point(double s, double& t) {
  Trajectory path = source_.start(s);
  if (!path.exists()) return {request_.seed.point_at(s), Vec3(0), Vec3(0)};
  path.reach(t, source_.sampler());
  t = std::min(t, path.time());
  return path.at(t);
}

std::vector<Vec3> ExactSurface::points_at(double s) {
  constexpr int times = 16;
  std::vector<Vec3> points;
  Trajectory path = source_.start(s);
  if (!path.exists()) return points;
  path.reach(request_.duration, source_.sampler());
  for (int i = 0; i <= times; ++i) points.push_back(path.position_at(path.time() * i / times));
  return points;
}

Deviation ExactSurface::deviation(Sample sample) {
  double &s = sample.s, &t = sample.t;
  FlowPoint here = point(s, t);
  for (int iteration = 0; iteration < 8; ++iteration) {
    const Vec3 off = sample.x - here.x;
    // Least squares for off ≈ w ds + v dt.
    const double ww = glm::dot(here.w, here.w), vv = glm::dot(here.v, here.v);
    const double wv = glm::dot(here.w, here.v), determinant = ww * vv - wv * wv;
    if (!(determinant > 1e-12 * ww * vv)) break;
    const double wo = glm::dot(here.w, off), vo = glm::dot(here.v, off);
    double next_s = s + (vv * wo - wv * vo) / determinant;
    double next_t = t + (ww * vo - wv * wo) / determinant;
    // On the surface's border one parameter is fixed, and the other one alone is corrected.
    if (!request_.seed.closed && (next_s < 0 || next_s > 1)) {
      next_s = std::clamp(next_s, 0.0, 1.0);
      next_t = t + (vo - wv * (next_s - s)) / vv;
    }
    if (next_t < 0 || next_t > request_.duration) {
      next_t = std::clamp(next_t, 0.0, request_.duration);
      next_s = s + (wo - wv * (next_t - t)) / ww;
      if (!request_.seed.closed) next_s = std::clamp(next_s, 0.0, 1.0);
    }
    const FlowPoint next = point(next_s, next_t);
    if (!(glm::distance(next.x, sample.x) < glm::length(off))) break;
    const bool settled = glm::distance(next.x, here.x) < 1e-4 * glm::length(off);
    s = next_s, t = next_t, here = next;
    if (settled) break;
  }
  const Vec3 normal = glm::cross(here.w, here.v);
  const double sine = glm::length(glm::cross(normal, sample.facet));
  return {glm::distance(here.x, sample.x),
          degrees * std::atan2(sine, glm::dot(normal, sample.facet))};
}

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

SurfaceError summary(std::span<const MeshSample> samples,
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
  return error;
}

/// Points of the surface whatever the mesh is: seeds are the fractions of multiples of 1/φ, which
/// no halving or even spacing comes near to again and again.
std::vector<Vec3> points_of_surface(ExactSurface& surface) {
  constexpr int seeds = 400;
  constexpr double inverse_golden_ratio = 0.61803398874989485;
  std::vector<std::vector<Vec3>> of_seed(seeds);
  parallel_for(0, seeds, [&](int i) {
    const double multiple = (i + 1) * inverse_golden_ratio;
    of_seed[std::size_t(i)] = surface.points_at(multiple - std::floor(multiple));
  });
  std::vector<Vec3> points;
  for (const auto& some : of_seed) points.insert(points.end(), some.begin(), some.end());
  return points;
}

}  // namespace

SurfaceError measure_error(const geometry::TriangleMesh& mesh, const SurfaceRequest& request,
                           std::uint64_t samples) {
  SurfaceSetup setup = surface_setup(request, SurfaceOptions{});
  setup.trajectory.tolerance = 1e-13 * setup.extent;
  // In samples a particle of the mesh may err by a tenth of theirs; the truth by a hundredth of it.
  setup.trajectory.error_floor *= 0.01;
  ExactSurface truth(request, setup);
  const std::vector<MeshSample> chosen = sample_mesh(mesh, samples);
  std::vector<Deviation> deviations(chosen.size());
  parallel_for(std::size_t(0), chosen.size(), [&](std::size_t i) {
    deviations[i] = truth.deviation(sample_of(mesh, chosen[i], request.seed.closed));
  });
  SurfaceError error = summary(chosen, deviations);
  error.max_from_surface = largest_distance(points_of_surface(truth), mesh);
  error.at_vertices = spread_to_vertices(mesh, chosen, deviations);
  return error;
}

}  // namespace pellucid::integrators
