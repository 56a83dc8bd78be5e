// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace pellucid::integrators {

/// Why a particle went no further.
enum class EndReason {
  duration,     // it ran its whole time
  left_domain,  // the field gives no sample beyond this point
  outside,      // the field gives no sample at its seed
  stagnated,    // in its whole duration it would not move a visible distance
  not_finite,   // the field's sample is NaN or infinite
  length,       // it ran its whole length
  steps,        // it used up its steps
  merged,       // its neighbours came together and went on without it
  vertex,       // it was sent for a single vertex, to mend a facet
  torn,         // the ribbons on both its sides were torn
  particles,    // a neighbour was needed and there were too many particles
  triangles,    // the surface has as many triangles as are allowed
  vertices      // the lines have as many vertices as are allowed
};

/// "duration", "left-domain", …; as `trace --json` prints them.
std::string_view name_of(EndReason reason);

/// Returns true when a particle ended since the field has no velocity where it is.
bool is_for_want_of_field(EndReason reason);

/// Returns true when the surface of a particle's neighbours has its border where it ended: not so
/// at rest, where it stays, nor where a budget cut it short.
bool is_border(EndReason reason);

/// Returns true when a budget ended a particle: the option "max-" and the reason's name.
bool is_budget(EndReason reason);

/// EndCounts are how many particles ended for which reason.
using EndCounts = std::map<EndReason, std::uint64_t>;

/// Returns the counts for messages: "3 outside, 1 left-domain".
std::string in_words(const EndCounts& ends);

}  // namespace pellucid::integrators
