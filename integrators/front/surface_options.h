// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/options/option_table.h"
#include "integrators/paths/stepping_options.h"

namespace pellucid::integrators {

/// SurfaceNormals say how the surface's tangent ∂x/∂s, and with it the normal, is known at a
/// particle.
enum class SurfaceNormals {
  variational,  // by the variational equation
  ghost,        // by a second particle beside it
  none          // not at all
};

/// A GhostControl says when the second particle is pulled back.
enum class GhostControl {
  reset,   // when it is too far
  rescale  // after every step
};

/// SurfaceOptions are what every surface integrator takes beside its own.
struct SurfaceOptions {
  SurfaceNormals normals = SurfaceNormals::variational;
  GhostControl ghost = GhostControl::reset;
  double rip = 1e-4;  // neighbours with closer seeds, in s, are torn where they part
  std::uint64_t max_particles = 1'000'000;  // the surface is not refined any more
  std::uint64_t max_triangles = 4'000'000;  // the surface ends: no default run goes on for minutes
  SteppingOptions stepping;
};

/// Returns the table of SurfaceOptions.
const OptionTable<SurfaceOptions>& surface_options();

}  // namespace pellucid::integrators
