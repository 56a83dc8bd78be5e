// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/front/surface_particles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "integrators/paths/seed_place.h"
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

void check(const SurfaceOptions& options) {
  if (options.ghost == GhostControl::rescale && options.normals != SurfaceNormals::ghost)
    throw InputError("ghost=rescale: there is no ghost; accepted: together with normals=ghost");
}

Companion companion_of(const SurfaceOptions& options) {
  switch (options.normals) {
    case SurfaceNormals::none:
      return Companion::none;
    case SurfaceNormals::variational:
      return Companion::variation;
    case SurfaceNormals::ghost:
      break;
  }
  return options.ghost == GhostControl::reset ? Companion::ghost_reset : Companion::ghost_rescaled;
}

}  // namespace

SurfaceSetup surface_setup(const SurfaceRequest& request, const SurfaceOptions& options) {
  check(request);
  check(options);
  SurfaceSetup setup{options};
  setup.extent = extent_of(request.seed);
  setup.trajectory =
      trajectory_options(*request.field, {request.duration, request.start_time, request.path},
                         setup.extent, options.stepping);
  setup.trajectory.companion = companion_of(options);
  if (setup.trajectory.companion == Companion::variation)
    setup.trajectory.velocity_error = request.field->sampling_error().value_or(0);
  setup.trajectory.ghost_distance = 1e-5 * setup.extent;
  return setup;
}

ParticleSource::ParticleSource(const SurfaceRequest& request, const SurfaceSetup& setup)
    : seed_(request.seed),
      domain_(request.field->domain()),
      options_(setup.trajectory),
      samplers_([field = request.field, length = setup.extent] {
        return CountingSampler(*field, length);
      }) {}

Trajectory ParticleSource::start(double s) {
  const double wrapped = seed_.closed ? s - std::floor(s) : s;
  const Vec3 seed = onto_edge(domain_, seed_.point_at(wrapped));
  // On the crease that starts at a corner ∂x/∂s is two vectors. Neither of them speaks for the
  // other side, and normals by it would seem to turn at once, however near the next particle is.
  const Vec3 tangent = is_corner(seed_, s) ? Vec3(0) : seed_.tangent_at(wrapped);
  return Trajectory(options_, seed, tangent, sampler());
}

std::uint64_t ParticleSource::evaluations() const {
  std::uint64_t count = 0;
  for (const CountingSampler& sampler : samplers_) count += sampler.evaluations();
  return count;
}

}  // namespace pellucid::integrators
