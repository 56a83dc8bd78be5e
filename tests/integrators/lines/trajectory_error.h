// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace pellucid::integrators {

/// By default a step's error is estimated at 1e-9 of the lines' extent, some units, and they take
/// some tens of steps: what they are off by, world units, if errors add up.
inline constexpr double trajectory_error = 1e-8;

}  // namespace pellucid::integrators
