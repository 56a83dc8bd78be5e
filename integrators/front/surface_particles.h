// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tbb/enumerable_thread_specific.h>

#include "integrators/paths/counting_sampler.h"
#include "integrators/paths/trajectory.h"
#include "integrators/surface_integrator.h"

namespace pellucid::integrators {

/// What every surface integrator takes beside its own parameters.
struct SurfaceOptions {
  TrajectoryOptions trajectory;
  double extent = 1;         // of the seed curve: the unit of what is relative
  double rip = 1e-6;         // neighbours whose seeds are closer, in s, are torn, not refined
  double facet_angle = 180;  // degrees: facets farther from their corners' normals are mended
  double shortest_edge = 0;  // world units: so far edges are split to that end
  std::uint64_t max_particles = 1'000'000;
  std::uint64_t max_triangles = 50'000'000;
};

/// Checks the request. Throws InputError.
SurfaceOptions surface_options(const SurfaceRequest& request, const Parameters& parameters);

/// Starts particles on the seed curve. Every thread has its own sampler of the field.
class ParticleSource {
 public:
  ParticleSource(const SurfaceRequest& request, const SurfaceOptions& options);

  /// s may run past 1 on a closed curve.
  Trajectory start(double s);
  fields::FieldSampler& sampler() { return samplers_.local(); }
  std::uint64_t evaluations() const;

 private:
  const SeedCurve& seed_;
  const TrajectoryOptions& options_;
  tbb::enumerable_thread_specific<CountingSampler> samplers_;
};

}  // namespace pellucid::integrators
