// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/vec.h"

namespace pellucid::geometry {

/// This is the colour of what has none: light grey.
inline const Vec3 default_color(0.8);

}  // namespace pellucid::geometry
