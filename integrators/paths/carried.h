// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fields/readers/attributes.h"
#include "geometry/vertices.h"

namespace pellucid::integrators {

/// Adds the attributes of the field's files to the scalars of what was integrated in it, whose
/// "time" is the field's (after turn_back()): NaN where the files have none. They are those of
/// `places`, world units, one for each vertex. Throws InputError for a name that the vertices have
/// already.
void carry(const fields::Attributes& attributes, std::span<const Vec3> places,
           geometry::Vertices& vertices);

}  // namespace pellucid::integrators
