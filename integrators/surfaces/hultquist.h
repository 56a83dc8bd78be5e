#pragma once

#include "integrators/surface_integrator.h"

namespace pellucid {

const IntegratorRow& hultquist_integrator();

}  // namespace pellucid
