// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What `trace` tells of what it has integrated.

#include <nlohmann/json_fwd.hpp>

#include "integrators/lines/integrate_lines.h"
#include "integrators/mesh/mesh_quality.h"
#include "integrators/surface_integrator.h"
#include "integrators/surfaces/surface_error.h"

namespace pellucid::compare {

/// Returns what a surface took, how many particles ended for which reason, and how sound its mesh
/// is.
nlohmann::ordered_json surface_json(const integrators::IntegratedSurface& surface,
                                    const integrators::MeshQuality& quality);

/// Adds how far the mesh is from the exact surface, in world units, and its normals, in degrees.
void add_error_json(nlohmann::ordered_json& json, const integrators::SurfaceError& error);

/// Returns what lines took, and how many particles ended for which reason.
nlohmann::ordered_json lines_json(const integrators::IntegratedLines& lines);

}  // namespace pellucid::compare
