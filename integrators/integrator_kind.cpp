// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/integrator_kind.h"

#include <algorithm>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/options/names.h"
#include "core/options/parameters.h"
#include "integrators/lines/integrate_lines.h"
#include "integrators/sheets/integrate_sheet.h"
#include "integrators/surfaces/integrate_surface.h"

namespace pellucid::integrators {

IntegratorKind integrator_kind(std::string_view integrator) {
  std::vector<std::string_view> names;
  std::vector<IntegratorKind> kinds;
  const auto add = [&](std::string_view name, IntegratorKind kind) {
    names.push_back(name);
    kinds.push_back(kind);
  };
  for (const IntegratorRow& row : integrators()) add(row.name, IntegratorKind::surface);
  for (const SheetIntegratorRow& row : sheet_integrators())
    add(row.name,
        row.seed == SheetSeed::curve ? IntegratorKind::streak_sheet : IntegratorKind::time_sheet);
  for (const LineIntegratorRow& row : line_integrators()) add(row.name, IntegratorKind::lines);
  const std::string name = parse_name_and_options(integrator).name;
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) throw InputError(unknown_name("integrator", name, names));
  return kinds[std::size_t(found - names.begin())];
}

}  // namespace pellucid::integrators
