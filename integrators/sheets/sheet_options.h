// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "core/options/option_table.h"
#include "integrators/paths/stepping_options.h"

namespace pellucid::integrators {

/// SheetOptions are those of streak and time surfaces.
struct SheetOptions {
  std::optional<double> tolerance;  // world units, > 0: mesh to surface; 1e-3 of the seeds' extent
  int particles = 33;               // along the longest way across the seeds, at the first look
  double rip = 1e-6;                // of the seeds: shorter sides are not halved
  std::uint64_t max_particles = 2'000'000;
  std::uint64_t max_triangles = 4'000'000;
  SteppingOptions stepping;
};

/// Returns the table of SheetOptions.
const OptionTable<SheetOptions>& sheet_options();

/// Returns the tolerance in world units: a thousandth of the seeds' `extent` unless one is given.
inline double sheet_tolerance(const SheetOptions& options, double extent) {
  return options.tolerance.value_or(1e-3 * extent);
}

}  // namespace pellucid::integrators
