// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace pellucid::integrators {

/// An IntegratorKind says what an integrator makes, and of what: a surface that a curve of seeds
/// sweeps; a sheet, which particles form at one moment, let go along a curve or on a surface; or
/// lines.
enum class IntegratorKind { surface, streak_sheet, time_sheet, lines };

/// Returns the kind of "NAME[:key=value,…]". Throws InputError that lists the integrators of all
/// kinds for an unknown name.
IntegratorKind integrator_kind(std::string_view integrator);

/// Returns true of both kinds of sheets.
inline bool is_sheet(IntegratorKind kind) {
  return kind == IntegratorKind::streak_sheet || kind == IntegratorKind::time_sheet;
}

}  // namespace pellucid::integrators
