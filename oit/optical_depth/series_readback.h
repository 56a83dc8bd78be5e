// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "oit/gl/gl_objects.h"
#include "scene/renderer.h"

namespace pellucid::oit {

/// Returns the integral (Eq. 5 of Baeza Rojo et al. 2019) of the series that a pixel has in an
/// array of coefficients, two bands in a layer, at the depths `d` in [0, 1], and the coefficients:
/// by the very formulas of the shaders. The series' period exceeds [0, 1] by `margin` on either
/// side.
scene::RaySeries read_series(const Texture& coefficients, int bands, float margin, int x, int y,
                             std::span<const double> d);

}  // namespace pellucid::oit
