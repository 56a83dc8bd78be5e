// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "integrators/paths/trajectory.h"

namespace pellucid::integrators {

/// A VertexSpacing says how far a line's vertices may lie apart on its trajectory.
struct VertexSpacing {
  double step = 0;      // world units between two vertices; 0: by the turn
  double turn = 0;      // radians that the direction turns by from one vertex to the next
  double longest = 0;   // time units
  double shortest = 0;  // world units: along a chord of that or less a turn is none
};

/// Returns when the vertex after that at time t comes: the trajectory is integrated as far, and
/// looked at from t on, until the way there is within the spacing. Where the flow jumps no way is
/// short enough, and the last one tried is taken.
double next_vertex_time(Trajectory& path, double t, const VertexSpacing& spacing,
                        fields::FieldSampler& sampler);

}  // namespace pellucid::integrators
