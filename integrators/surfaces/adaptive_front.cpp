// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/surfaces/adaptive_front.h"

#include "integrators/front/refining_front.h"
#include "integrators/surfaces/synchronous_front.h"

namespace pellucid::integrators {
namespace {

/// The paper's threshold for the front's particles, in world units; in time its rows lie closer.
constexpr double default_threshold = 0.5, rows_per_threshold = 5;

using AdaptiveFrontOptions = RefiningOptions<500>;

const OptionTable<AdaptiveFrontOptions>& adaptive_front_options() {
  static const auto table = refining_options<AdaptiveFrontOptions>(default_threshold);
  return table;
}

IntegratedSurface run_adaptive(const SurfaceRequest& request, const Parameters& parameters) {
  return run_refining(
      request, adaptive_front_options().read(parameters), default_threshold, rows_per_threshold,
      [](SurfaceRun& run, const Refinement& refinement, std::span<const double> seeds, bool ring) {
        SynchronousFront(run, refinement, 0).sweep(seeds, ring);
      });
}

}  // namespace

const IntegratorRow& adaptive_front_integrator() {
  static const IntegratorRow row = {
      .name = "adaptive-front",
      .title = "Front line with particles inserted and removed",
      .citation =
          "as compared in Tian & Günther, Progressive Rendering of Transparent Integral Surfaces, "
          "additional material, Fig. 4, middle left",
      .parameters = adaptive_front_options().specs(),
      .promises = {.refines = true, .coarsens = true, .bounds_error = true},
      .run = run_adaptive,
      .default_threshold = default_threshold,
  };
  return row;
}

}  // namespace pellucid::integrators
