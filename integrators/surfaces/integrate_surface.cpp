// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/surfaces/integrate_surface.h"

#include <fmt/format.h>

#include "core/error.h"
#include "core/options/names.h"
#include "geometry/finite_vertices.h"
#include "integrators/paths/seed_place.h"
#include "integrators/surfaces/adaptive_front.h"
#include "integrators/surfaces/fixed_front.h"
#include "integrators/surfaces/hultquist.h"

namespace pellucid::integrators {
namespace {

/// What may help, when the field has no velocity where particles began or ended.
std::string advice(const SurfaceRequest& request, const EndCounts& ends) {
  for (const auto& [reason, count] : ends)
    if (is_for_want_of_field(reason)) return "; " + accepted_seeds(*request.field);
  return "";
}

}  // namespace

std::span<const IntegratorRow> integrators() {
  static const IntegratorRow table[] = {fixed_front_integrator(), adaptive_front_integrator(),
                                        hultquist_integrator()};
  return table;
}

IntegratedSurface integrate_surface(std::string_view integrator, const SurfaceRequest& request) {
  const NameAndOptions parsed = parse_name_and_options(integrator);
  const IntegratorRow& row = find_row("integrator", parsed.name, integrators());
  IntegratedSurface surface =
      row.run(request, Parameters(row.name, row.parameters, parsed.options));
  if (surface.mesh.triangles.empty())
    throw InputError(fmt::format("{}: no triangle came of {} particles; they ended: {}{}", row.name,
                                 surface.stats.particles, in_words(surface.stats.ends),
                                 advice(request, surface.stats.ends)));
  geometry::check_finite(row.name, surface.mesh);
  return surface;
}

}  // namespace pellucid::integrators
