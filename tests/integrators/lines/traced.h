// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "integrators/lines/integrate_lines.h"

namespace pellucid::integrators::testing {

/// Returns the lines of these seeds, from the field's time 0 on.
inline IntegratedLines trace(const fields::VectorField& field, std::string_view integrator,
                             std::vector<Vec3> seeds, double duration) {
  return integrate_lines(integrator, {&field, std::move(seeds), duration, 0, {}});
}

/// Returns where the line of one seed ends.
inline Vec3 end_of(const fields::VectorField& field, std::string_view integrator, const Vec3& seed,
                   double duration) {
  return trace(field, integrator, {seed}, duration).lines.positions.back();
}

}  // namespace pellucid::integrators::testing
