// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/vec.h"

namespace pellucid::integrators {

/// Returns exp(a time) w: what becomes of w by dw/dt = a w, `a` in 1 / time units. Where that
/// leaves a double's range it is so up to a positive factor, the same for every w; where a or the
/// time has no finite size w stays as it is.
Vec3 carried_linearly(const Mat3& a, double time, const Vec3& w);

}  // namespace pellucid::integrators
