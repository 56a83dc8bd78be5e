// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/surfaces/integrate_surface.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "core/options/names.h"
#include "geometry/finite_vertices.h"
#include "integrators/paths/magnitude.h"
#include "integrators/paths/seed_place.h"
#include "integrators/surfaces/adaptive_front.h"
#include "integrators/surfaces/fixed_front.h"
#include "integrators/surfaces/hultquist.h"

namespace pellucid::integrators {
std::span<const IntegratorRow> integrators() {
  static const IntegratorRow table[] = {fixed_front_integrator(), adaptive_front_integrator(),
                                        hultquist_integrator()};
  return table;
}

namespace {

/// Seeds along the flow may make triangles that are lines.
bool has_area(const geometry::TriangleMesh& mesh) {
  return std::ranges::any_of(mesh.triangles, [&](const auto& corners) {
    const Vec3& x = mesh.positions[corners[0]];
    const Vec3 one = mesh.positions[corners[1]] - x, other = mesh.positions[corners[2]] - x;
    return glm::cross(direction_of(one), direction_of(other)) != Vec3(0);
  });
}

}  // namespace

Parameters integrator_parameters(std::string_view integrator) {
  const NameAndOptions parsed = parse_name_and_options(integrator);
  const IntegratorRow& row = find_row("integrator", parsed.name, integrators());
  return Parameters(row.name, row.parameters, parsed.options);
}

IntegratedSurface integrate_surface(std::string_view integrator, const SurfaceRequest& request) {
  const Parameters parameters = integrator_parameters(integrator);
  const IntegratorRow& row = find_row("integrator", parameters.owner(), integrators());
  IntegratedSurface surface = row.run(request, parameters);
  if (!has_area(surface.mesh))
    throw InputError(fmt::format("{}: no triangle came of {} particles; {}", row.name,
                                 surface.stats.particles,
                                 ended_in_words(surface.stats.ends, *request.field)));
  geometry::check_finite(row.name, surface.mesh);
  return surface;
}

}  // namespace pellucid::integrators
