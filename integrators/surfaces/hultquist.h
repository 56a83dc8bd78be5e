// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "integrators/surface_integrator.h"

namespace pellucid::integrators {

/// Returns Hultquist's recursive ribbons (1992): a ribbon that lags behind is advanced first, and
/// splits or merges where its width asks for it.
const IntegratorRow& hultquist_integrator();

}  // namespace pellucid::integrators
