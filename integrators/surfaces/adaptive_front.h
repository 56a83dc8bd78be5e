// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "integrators/surface_integrator.h"

namespace pellucid::integrators {

/// Returns the front line with particles inserted and removed, as Tian and Günther compare it
/// (additional material, Fig. 4, middle left).
const IntegratorRow& adaptive_front_integrator();

}  // namespace pellucid::integrators
