// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

#include "fields/field.h"
#include "integrators/paths/seed_curve.h"

namespace pellucid::integrators {

/// Throws InputError, with the integrator's name, where the seed curve runs along the flow at all
/// of these times wherever the flow moves: particles then follow each other, and what they sweep
/// has no area, however many triangles were made of it. A thousand places of the curve are looked
/// at, at the first of which it crosses the flow this returns.
void check_across_flow(std::string_view integrator, const SeedCurve& seed,
                       const fields::VectorField& field, std::span<const double> times);

}  // namespace pellucid::integrators
