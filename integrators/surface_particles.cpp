#include "integrators/surface_particles.h"

#include <fmt/format.h>

#include <cmath>

#include "core/error.h"
#include "core/names.h"

namespace pellucid {
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
  if (!(request.duration > 0) || !std::isfinite(request.duration))
    throw InputError(fmt::format("duration: {}; accepted: a finite number > 0", request.duration));
  if (!std::isfinite(request.start_time))
    throw InputError(fmt::format("start-time: {}; accepted: a finite number", request.start_time));
}

Companion companion_of(const Parameters& parameters) {
  const std::string& normals = parameters.text("normals");
  if (normals == "none") return Companion::none;
  if (normals == "variational") return Companion::variation;
  return parameters.text("ghost") == "reset" ? Companion::ghost_reset : Companion::ghost_rescaled;
}

}  // namespace

double positive(const Parameters& parameters, std::string_view name, double otherwise) {
  if (!parameters.is_set(name)) return otherwise;
  const double value = parameters.real(name);
  if (!(value > 0)) throw InputError(fmt::format("{}={}; accepted: number > 0", name, value));
  return value;
}

SurfaceOptions surface_options(const SurfaceRequest& request, const Parameters& parameters) {
  check(request);
  SurfaceOptions options;
  options.extent = extent_of(request.seed);
  options.rip = parameters.real("rip");
  options.max_particles = std::uint64_t(parameters.real("max-particles"));
  options.max_triangles = std::uint64_t(parameters.real("max-triangles"));

  TrajectoryOptions& trajectory = options.trajectory;
  trajectory.stepper = &find_row("stepper", parameters.text("stepper"), steppers());
  trajectory.duration = request.duration;
  trajectory.start_time = request.start_time;
  trajectory.path = request.path;
  trajectory.tolerance = positive(parameters, "accuracy", 1e-9 * options.extent);
  trajectory.max_length = positive(parameters, "length", trajectory.max_length);
  trajectory.max_steps = std::uint64_t(parameters.real("max-steps"));
  trajectory.max_step = positive(
      parameters, "dt", trajectory.stepper->adaptive ? request.duration : request.duration / 500);
  // Samples are only piecewise smooth: a step may not jump over a cell.
  if (const auto cell = request.field->cell_size()) trajectory.max_move = 0.5 * *cell;
  trajectory.velocity_error = request.field->sampling_error().value_or(0);
  trajectory.still = 1e-12 * options.extent;
  trajectory.companion = companion_of(parameters);
  trajectory.ghost_distance = 1e-5 * options.extent;
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

}  // namespace pellucid
