// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "integrators/surface_integrator.h"

namespace pellucid::integrators {

/// Returns the front line without refinement: all particles of the seed curve, no others, as Tian
/// and Günther compare it (additional material, Fig. 4, left).
const IntegratorRow& fixed_front_integrator();

}  // namespace pellucid::integrators
