// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

#include "integrators/surface_integrator.h"

namespace pellucid::integrators {

/// The surface integrators, one row each.
std::span<const IntegratorRow> integrators();

/// Returns the parameters of an integrator, "NAME[:key=value,…]". Throws InputError as
/// integrate_surface() does of it.
Parameters integrator_parameters(std::string_view integrator);

/// `integrator` is "NAME[:key=value,…]". Throws InputError for an unknown name, key or value, and
/// for a request that no surface can be made of.
IntegratedSurface integrate_surface(std::string_view integrator, const SurfaceRequest& request);

}  // namespace pellucid::integrators
