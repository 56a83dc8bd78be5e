// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "integrators/surface_integrator.h"

namespace pellucid::integrators {

/// Throws InputError where an integrator, by its name, has made no triangle with an area, as seeds
/// along the flow do, with how its particles ended in `field`; and where a vertex is not finite.
void check_surface(std::string_view integrator, const IntegratedSurface& surface,
                   const fields::VectorField& field);

}  // namespace pellucid::integrators
