// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tbb/enumerable_thread_specific.h>

#include "integrators/front/surface_options.h"
#include "integrators/paths/counting_sampler.h"
#include "integrators/paths/trajectory.h"
#include "integrators/surface_integrator.h"

namespace pellucid::integrators {

/// A SurfaceSetup is what a surface is swept by: the options, and what follows from them for its
/// request.
struct SurfaceSetup : SurfaceOptions {
  TrajectoryOptions trajectory = {};
  double extent = 1;         // world units, of the seed curve: the unit of what is relative
  bool refines = false;      // the front adds particles: the seed curve is searched for features
  double facet_angle = 180;  // degrees: facets farther from their corners' normals are mended
  double shortest_edge = 0;  // world units: so far edges are split to that end
};

/// Checks the request. Throws InputError.
SurfaceSetup surface_setup(const SurfaceRequest& request, const SurfaceOptions& options);

/// Starts particles on the seed curve. Every thread has its own sampler of the field.
class ParticleSource {
 public:
  ParticleSource(const SurfaceRequest& request, const SurfaceSetup& setup);

  /// s may run past 1 on a closed curve. At a corner the particle has no ∂x/∂s.
  Trajectory start(double s);
  fields::FieldSampler& sampler() { return samplers_.local(); }
  std::uint64_t evaluations() const;

 private:
  const SeedCurve& seed_;
  Box3 domain_;  // of the field
  const TrajectoryOptions& options_;
  tbb::enumerable_thread_specific<CountingSampler> samplers_;
};

}  // namespace pellucid::integrators
