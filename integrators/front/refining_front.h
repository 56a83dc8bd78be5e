// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/options/option_table.h"
#include "integrators/front/refinement.h"
#include "integrators/front/surface_options.h"
#include "integrators/front/surface_run.h"
#include "integrators/paths/trajectory_options.h"

namespace pellucid::integrators {

/// RefiningOptions are those of an integrator whose front takes in particles and lets them go;
/// `first_particles` is how many there are to begin with, by default.
template <int first_particles>
struct RefiningOptions {
  int particles = first_particles;  // evenly spaced on the seed curve, to begin with
  RefinementOptions refinement;
  SurfaceOptions surface;
};

/// Makes the table of such options; `default_threshold` is in world units.
template <class Options>
OptionTable<Options> refining_options(double default_threshold) {
  return {number("particles", &Options::particles,
                 {.min = 2,
                  .max = 1e6,
                  .unit = "particles",
                  .help = "evenly spaced on the seed curve; more follow where they are needed"}),
          part(&Options::refinement, refinement_options(default_threshold)),
          part(&Options::surface, surface_options())};
}

/// Sweeps the surface and mends its facets. `sweep(run, refinement, seeds, ring)` tiles one piece
/// of the seed curve; a trajectory has `steps_per_threshold` vertices over a threshold's length.
/// Throws InputError as surface_setup() and refinement_of() do.
template <class Options, class SweepPiece>
IntegratedSurface run_refining(const SurfaceRequest& request, const Options& options,
                               double default_threshold, double steps_per_threshold,
                               const SweepPiece& sweep) {
  check_keeps_tolerance(options.surface.stepping, options.refinement.tolerance);
  SurfaceSetup setup = surface_setup(request, options.surface);
  const Refinement refinement =
      refinement_of(options.refinement, default_threshold, steps_per_threshold);
  // What errors of neighbours differ by would else be wrinkles, which a front refines in vain.
  bound_errors(setup.trajectory, shortest_edge(refinement));
  bound_facets(setup, options.refinement.facet_angle, refinement, options.particles);
  return run_surface(request, setup, options.particles,
                     [&](SurfaceRun& run, std::span<const double> seeds, bool ring) {
                       sweep(run, refinement, seeds, ring);
                     });
}

}  // namespace pellucid::integrators
