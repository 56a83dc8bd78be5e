// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "integrators/lines/integrate_lines.h"

namespace pellucid::integrators {

/// Returns the length that is the unit of what is relative, the default accuracy above all, in
/// world units: the diagonal of the seeds' box. A single seed has none; it takes that of the
/// field's domain or, where that is unbounded, the length over which the velocity changes. Never
/// one that grows with the duration where the flow turns: a particle on a circle stays on it.
double seeds_extent(const LineRequest& request, bool path);

}  // namespace pellucid::integrators
