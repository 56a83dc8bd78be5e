// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "fields/field.h"
#include "integrators/paths/end_reason.h"
#include "integrators/paths/seed_curve.h"

namespace pellucid::integrators {

/// Returns where a particle starts, in world units: `seed`, or the domain's nearest point when the
/// seed misses it by no more than a float's rounding of its bounds. Files hold bounds as floats,
/// and who types 0.1 means the edge at 0.1f, or the other way round.
Vec3 onto_edge(const Box3& domain, const Vec3& seed);

/// Returns true when the curve has no one tangent at s, to 1e-9. s may run past 1 on a closed
/// curve, whose seam is a corner like any other.
bool is_corner(const SeedCurve& curve, double s);

/// Returns a position for messages: "(0, 0.5, 1)".
std::string in_words(const Vec3& x);

/// Returns what a message says of particles that went nowhere: how they ended, with the field's
/// name, and its bounds where they ended since it has no velocity.
std::string ended_in_words(const EndCounts& ends, const fields::VectorField& field);

}  // namespace pellucid::integrators
