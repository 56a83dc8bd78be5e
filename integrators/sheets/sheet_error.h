// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/options/parameters.h"
#include "integrators/sheets/sheet_integrator.h"
#include "integrators/surfaces/surface_error.h"

namespace pellucid::integrators {

/// Measures how far a sheet is from the surface it stands for, as measure_error() does of swept
/// surfaces: from samples of the mesh, the nearest point of the exact sheet around the sample's own
/// place is sought, whose particles are sent at the tightest tolerance; and points of the exact
/// sheet, which know nothing of the mesh's, give `max_from_surface`. On the seeds of a mesh nearest
/// points are sought within a facet: an upper bound there. `integrator` holds the sheet's own
/// parameters.
SurfaceError measure_sheet_error(const IntegratedSheet& sheet, const SheetRequest& request,
                                 std::uint64_t samples, const Parameters& integrator);

}  // namespace pellucid::integrators
