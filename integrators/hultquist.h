#pragma once

#include "integrators/integrate_surface.h"

namespace pellucid {

const IntegratorRow& hultquist_integrator();

}  // namespace pellucid
