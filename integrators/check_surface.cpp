// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/check_surface.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "geometry/finite_vertices.h"
#include "integrators/mesh/facet_normal.h"
#include "integrators/paths/seed_place.h"

namespace pellucid::integrators {

void check_surface(std::string_view integrator, const IntegratedSurface& surface,
                   const fields::VectorField& field) {
  const geometry::TriangleMesh& mesh = surface.mesh;
  const auto is_facet = [&](const auto& corners) {
    const auto& [a, b, c] = corners;
    return has_area(mesh.positions[a], mesh.positions[b], mesh.positions[c]);
  };
  if (std::ranges::none_of(mesh.triangles, is_facet))
    throw InputError(fmt::format("{}: no triangle came of {} particles; {}", integrator,
                                 surface.stats.particles,
                                 ended_in_words(surface.stats.ends, field)));
  geometry::check_finite(integrator, mesh);
}

}  // namespace pellucid::integrators
