// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

#include "integrators/sheets/sheet_domain.h"
#include "integrators/sheets/sheet_integrator.h"

namespace pellucid::integrators {

/// The integrators of sheets, one row each: streak-surface, time-surface.
std::span<const SheetIntegratorRow> sheet_integrators();

/// Returns the parameters of "NAME[:key=value,…]". Throws InputError for an unknown name, key or
/// value.
Parameters sheet_parameters(std::string_view integrator);

/// Returns the parameters of what is asked for. It needs a curve, or else a surface.
SheetDomain sheet_domain(const SheetRequest& request);

/// `integrator` is "NAME[:key=value,…]". The result is the same to the last bit for any number of
/// threads. Throws InputError for an unknown name, key or value, for seeds of the other kind, and
/// for a request that no sheet can be made of.
IntegratedSheet integrate_sheet(std::string_view integrator, const SheetRequest& request);

}  // namespace pellucid::integrators
