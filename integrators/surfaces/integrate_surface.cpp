// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/surfaces/integrate_surface.h"

#include <array>

#include "core/options/names.h"
#include "integrators/check_surface.h"
#include "integrators/paths/seeds_along_flow.h"
#include "integrators/surfaces/adaptive_front.h"
#include "integrators/surfaces/fixed_front.h"
#include "integrators/surfaces/hultquist.h"

namespace pellucid::integrators {
namespace {

/// Of a path surface in an unsteady field only the triangles can tell: what runs along the flow at
/// first may cross it later.
void check_seeds(std::string_view name, const SurfaceRequest& request) {
  const bool stands_still = request.field && (!request.path || request.field->steady());
  if (stands_still && request.seed.point_at && request.seed.tangent_at)
    check_across_flow(name, request.seed, *request.field, std::array{request.start_time});
}

}  // namespace

std::span<const IntegratorRow> integrators() {
  static const IntegratorRow table[] = {fixed_front_integrator(), adaptive_front_integrator(),
                                        hultquist_integrator()};
  return table;
}

Parameters integrator_parameters(std::string_view integrator) {
  const NameAndOptions parsed = parse_name_and_options(integrator);
  const IntegratorRow& row = find_row("integrator", parsed.name, integrators());
  return Parameters(row.name, row.parameters, parsed.options);
}

IntegratedSurface integrate_surface(std::string_view integrator, const SurfaceRequest& request) {
  const Parameters parameters = integrator_parameters(integrator);
  const IntegratorRow& row = find_row("integrator", parameters.owner(), integrators());
  check_seeds(row.name, request);
  IntegratedSurface surface = row.run(request, parameters);
  check_surface(row.name, surface, *request.field);
  return surface;
}

}  // namespace pellucid::integrators
