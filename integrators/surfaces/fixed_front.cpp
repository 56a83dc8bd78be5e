// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/surfaces/fixed_front.h"

#include "integrators/front/surface_options.h"
#include "integrators/surfaces/synchronous_front.h"

namespace pellucid::integrators {
namespace {

struct FixedFrontOptions {
  int particles = 500;  // evenly spaced on the seed curve
  int rows = 200;       // of vertices, evenly spaced in time
  SurfaceOptions surface;
};

const OptionTable<FixedFrontOptions>& fixed_front_options() {
  using Options = FixedFrontOptions;
  static const OptionTable<Options> table{
      number(
          "particles", &Options::particles,
          {.min = 2, .max = 1e6, .unit = "particles", .help = "evenly spaced on the seed curve"}),
      number("rows", &Options::rows,
             {.min = 1, .max = 1e6, .unit = "rows", .help = "of vertices, evenly spaced in time"}),
      part(&Options::surface, surface_options())};
  return table;
}

IntegratedSurface run_fixed(const SurfaceRequest& request, const Parameters& parameters) {
  const FixedFrontOptions options = fixed_front_options().read(parameters);
  const SurfaceSetup setup = surface_setup(request, options.surface);
  const Refinement none{.threshold = std::numeric_limits<double>::infinity()};
  return run_surface(request, setup, options.particles,
                     [&](SurfaceRun& run, std::span<const double> seeds, bool ring) {
                       SynchronousFront(run, none, options.rows).sweep(seeds, ring);
                     });
}

}  // namespace

const IntegratorRow& fixed_front_integrator() {
  static const IntegratorRow row = {
      .name = "fixed-front",
      .title = "Front line without refinement",
      .citation =
          "as compared in Tian & Günther, Progressive Rendering of Transparent Integral Surfaces, "
          "additional material, Fig. 4, left",
      .parameters = fixed_front_options().specs(),
      .promises = {},
      .run = run_fixed,
  };
  return row;
}

}  // namespace pellucid::integrators
