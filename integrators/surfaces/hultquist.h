// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "integrators/surface_integrator.h"

namespace pellucid::integrators {

const IntegratorRow& hultquist_integrator();

}  // namespace pellucid::integrators
