// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "integrators/front/front_particle.h"
#include "integrators/front/refinement.h"
#include "integrators/front/surface_builder.h"
#include "integrators/front/surface_particles.h"

namespace pellucid::integrators {

/// A SurfaceRun is what the fronts of one surface share: where particles and triangles go, and the
/// budgets.
class SurfaceRun {
 public:
  SurfaceRun(const SurfaceRequest& request, const SurfaceSetup& options);

  /// A trajectory from the seed at s, integrated to time t or, where it ends after `earliest`, to
  /// its end; nothing when it ends before.
  std::unique_ptr<Trajectory> spawn(double s, double t, double earliest);
  fields::FieldSampler& sampler() { return source_.sampler(); }

  std::uint32_t add_vertex(const FrontParticle& particle);
  /// One that has a vertex twice is left out.
  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);

  /// The front could be refined no further between these seeds.
  void tear(double s0, double s1) { tears_.emplace_back(s0, s1); }
  /// A new particle may be had; else the reason is counted where the ribbon ends.
  bool may_spawn();
  bool is_full();  // no more triangles may be made

  /// Counts why they ended.
  void retire(std::span<const FrontParticle> particles);
  /// Ends a trajectory, if there is one, that was no particle of the front.
  void drop(std::unique_ptr<Trajectory> path, EndReason reason);

  const SurfaceSetup& options() const { return options_; }
  /// A path surface of an unsteady field: places have a time, and velocities compare only at one.
  bool is_unsteady() const { return request_.path && !request_.field->steady(); }
  const std::vector<std::pair<double, double>>& tears() const { return tears_; }
  /// Once the fronts are through: no facet stands off the surface farther than the options say.
  void mend();
  IntegratedSurface finish();

 private:
  const SurfaceRequest& request_;
  const SurfaceSetup& options_;
  ParticleSource source_;
  SurfaceBuilder builder_;
  std::vector<std::pair<double, double>> tears_;
  std::optional<EndReason> budget_;
  SurfaceStats stats_;
};

/// For rows that refine: no facet is to be farther from its corners' normals than `facet_angle`
/// degrees, and features of the field along the seed curve get particles of their own, beside the
/// first `particles`.
void bound_facets(SurfaceSetup& setup, double facet_angle, const Refinement& refinement,
                  int particles);

/// Sweeps a stretch of the seed curve from these seeds, ascending in s; a ring closes from the last
/// to the first.
using Sweep = std::function<void(SurfaceRun& run, std::span<const double> seeds, bool ring)>;

/// Sweeps the seed curve from `particles` evenly spaced seeds, its corners and, where
/// setup.refines, the features of the field along it. Where the front had to be torn, the surface
/// is swept a second time without the stretches between those seeds, so that no triangle before the
/// tear spans it.
IntegratedSurface run_surface(const SurfaceRequest& request, const SurfaceSetup& options,
                              int particles, const Sweep& sweep);

}  // namespace pellucid::integrators
