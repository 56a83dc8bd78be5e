// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/surfaces/integrate_surface.h"

#include <fmt/format.h>

#include "core/error.h"
#include "core/options/names.h"
#include "integrators/surfaces/adaptive_front.h"
#include "integrators/surfaces/fixed_front.h"
#include "integrators/surfaces/hultquist.h"

namespace pellucid::integrators {
namespace {

std::string listed(const EndCounts& ends) {
  std::string text;
  for (const auto& [reason, count] : ends)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, name_of(reason));
  return text;
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
    throw InputError(fmt::format("{}: no triangle came of {} particles; they ended: {}", row.name,
                                 surface.stats.particles, listed(surface.stats.ends)));
  return surface;
}

}  // namespace pellucid::integrators
