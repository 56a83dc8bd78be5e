#include "integrators/surface_error.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "integrators/surface_parameters.h"
#include "integrators/surface_particles.h"

namespace pellucid {
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

/// Barycentric points of a triangle: its middle and those of its sides, where linear interpolation
/// of a curved surface errs most.
constexpr std::array<std::array<double, 3>, 4> places = {
    {{1. / 3, 1. / 3, 1. / 3}, {0.5, 0.5, 0}, {0, 0.5, 0.5}, {0.5, 0, 0.5}}};

Sample sample_of(const TriangleMesh& mesh, std::size_t triangle, std::size_t place, bool closed) {
  const auto& corners = mesh.triangles[triangle];
  const auto &s = mesh.scalars.at("s"), &t = mesh.scalars.at("t");
  double first = s[corners[0]];
  Sample sample{0, 0, Vec3(0), Vec3(0)};
  for (int k = 0; k < 3; ++k) {
    const double weight = places[place][k];
    // Over the seam of a closed curve s jumps from 1 to 0.
    const double turn = closed ? std::round(first - s[corners[k]]) : 0;
    sample.s += weight * (s[corners[k]] + turn);
    sample.t += weight * t[corners[k]];
    sample.x += weight * mesh.positions[corners[k]];
  }
  const Vec3& x = mesh.positions[corners[0]];
  const Vec3 area = glm::cross(mesh.positions[corners[1]] - x, mesh.positions[corners[2]] - x);
  const double length = glm::length(area);
  sample.facet = length > 0 ? area / length : Vec3(0);
  return sample;
}

class ExactSurface {
 public:
  ExactSurface(const SurfaceRequest& request, const SurfaceOptions& options)
      : request_(request), source_(request, options) {}

  Deviation deviation(Sample sample);

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

SurfaceError summary(const std::vector<Deviation>& deviations) {
  SurfaceError error;
  error.samples = deviations.size();
  for (const Deviation& d : deviations) {
    error.mean += d.distance / double(deviations.size());
    error.rms += d.distance * d.distance / double(deviations.size());
    error.max = std::max(error.max, d.distance);
    error.normal_mean_degrees += d.degrees / double(deviations.size());
    error.normal_max_degrees = std::max(error.normal_max_degrees, d.degrees);
  }
  error.rms = std::sqrt(error.rms);
  return error;
}

}  // namespace

SurfaceError measure_error(const TriangleMesh& mesh, const SurfaceRequest& request,
                           std::uint64_t samples) {
  SurfaceOptions options = surface_options(request, Parameters("truth", surface_parameters, {}));
  options.trajectory.tolerance = 1e-13 * options.extent;
  const std::uint64_t all = mesh.triangles.size() * places.size();
  const std::uint64_t count = std::min(samples, all);
  ExactSurface truth(request, options);
  std::vector<Deviation> deviations(count);
  tbb::parallel_for(std::uint64_t(0), count, [&](std::uint64_t i) {
    // Evenly over all places, each triangle in turn by another of its four.
    const std::uint64_t at = std::uint64_t(double(i) / double(count) * double(all));
    const std::size_t place = count < all ? i % places.size() : at % places.size();
    deviations[i] =
        truth.deviation(sample_of(mesh, at / places.size(), place, request.seed.closed));
  });
  return summary(deviations);
}

}  // namespace pellucid
