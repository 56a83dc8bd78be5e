// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string_view>

namespace pellucid::integrators {

/// Why a particle went no further.
enum class EndReason {
  duration,     // it ran its whole time
  left_domain,  // the field gives no sample beyond this point
  stagnated,    // in its whole duration it would not move a visible distance
  not_finite,   // the field's sample is NaN or infinite
  length,       // it ran its whole length
  steps,        // it used up its steps
  merged,       // its neighbours came together and went on without it
  vertex,       // it was sent for a single vertex, to mend a facet
  torn,         // the ribbons on both its sides were torn
  particles,    // a neighbour was needed and there were too many particles
  triangles     // the surface has as many triangles as are allowed
};

/// "duration", "left-domain", …; as `trace --json` prints them.
std::string_view name_of(EndReason reason);

/// EndCounts are how many particles ended for which reason.
using EndCounts = std::map<EndReason, std::uint64_t>;

}  // namespace pellucid::integrators
