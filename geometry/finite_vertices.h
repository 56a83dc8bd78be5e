// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "geometry/vertices.h"

namespace pellucid::geometry {

/// Throws InputError that names `what` and the first vertex whose position, in world units, is not
/// finite: no file gets such a one.
void check_finite(std::string_view what, const Vertices& vertices);

}  // namespace pellucid::geometry
