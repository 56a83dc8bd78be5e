// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Ways against time: a negative duration is a positive one in the reversed field
// (reversed_field.h), and what comes of it has its times turned back.

#include <memory>

#include "fields/field.h"
#include "geometry/vertices.h"

namespace pellucid::integrators {

/// Returns the reversed field, which keeps no hold on `field`: that has to outlive it.
std::shared_ptr<const fields::VectorField> reversed_view(const fields::VectorField& field,
                                                         double start_time);

/// Turns the scalars "t" (since the seed: now below 0), "time" and "released" (the field's) of what
/// particles have made in `field`, where it is a reversed one; of another field they stay.
void turn_back(geometry::Vertices& vertices, const fields::VectorField& field);

}  // namespace pellucid::integrators
