// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/front/surface_particles.h"

#include <fmt/format.h>

#include <cmath>

#include "core/error.h"
#include "integrators/paths/trajectory_options.h"

namespace pellucid::integrators {
namespace {

double extent_of(const SeedCurve& seed) {
  Box3 box;
  for (int i = 0; i <= 64; ++i) box.extend(seed.point_at(i / 64.));
  const double extent = box.diagonal();
  if (!(extent > 0) || !std::isfinite(extent))
    throw InputError(fmt::format(
        "seed curve: its extent is {}; accepted: finite points that are not all the same", extent));
  return extent;
}

void check(const SurfaceRequest& request) {
  if (!request.field || !request.seed.point_at || !request.seed.tangent_at)
    throw InputError("integrate: a field and a seed curve are needed");
}

Companion companion_of(const Parameters& parameters) {
  const std::string& normals = parameters.text("normals");
  if (normals == "none") return Companion::none;
  if (normals == "variational") return Companion::variation;
  return parameters.text("ghost") == "reset" ? Companion::ghost_reset : Companion::ghost_rescaled;
}

}  // namespace

SurfaceOptions surface_options(const SurfaceRequest& request, const Parameters& parameters) {
  check(request);
  SurfaceOptions options;
  options.extent = extent_of(request.seed);
  options.rip = parameters.real("rip");
  options.max_particles = std::uint64_t(parameters.real("max-particles"));
  options.max_triangles = std::uint64_t(parameters.real("max-triangles"));

  options.trajectory =
      trajectory_options(*request.field, {request.duration, request.start_time, request.path},
                         options.extent, parameters);
  options.trajectory.companion = companion_of(parameters);
  options.trajectory.ghost_distance = 1e-5 * options.extent;
  return options;
}

ParticleSource::ParticleSource(const SurfaceRequest& request, const SurfaceOptions& options)
    : seed_(request.seed),
      options_(options.trajectory),
      samplers_([field = request.field] { return CountingSampler(*field); }) {}

Trajectory ParticleSource::start(double s) {
  const double wrapped = seed_.closed ? s - std::floor(s) : s;
  return Trajectory(options_, seed_.point_at(wrapped), seed_.tangent_at(wrapped), sampler());
}

std::uint64_t ParticleSource::evaluations() const {
  std::uint64_t count = 0;
  for (const CountingSampler& sampler : samplers_) count += sampler.evaluations();
  return count;
}

}  // namespace pellucid::integrators
