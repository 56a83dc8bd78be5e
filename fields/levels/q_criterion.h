// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fields/levels/level.h"

namespace pellucid::fields {

/// Returns the Q-criterion of a sampled velocity, per squared unit of time, in the numbers that the
/// velocity has, computed in doubles: Li and Chen, Multi-Resolution Isosurface Rendering (2023),
/// Eq. 1 (J. C. R. Hunt, A. A. Wray, P. Moin, CTR-S88 (1988)),
///   Q = -½ (u_x² + v_y² + w_z²) - u_y v_x - u_z w_x - v_z w_y,
/// for a flow without divergence half of |Ω|² - |S|². As there, derivatives inside a level are
/// central differences. At the level's faces they are one-sided, (-3 f₀ + 4 f₁ - f₂) / 2h, also of
/// second order: the report reads whatever its grid holds beyond its active voxels, which wraps
/// every level in a false shell.
///@{
ScalarLevel q_criterion(const VectorLevel& velocity);
DoubleLevel q_criterion(const DoubleVectorLevel& velocity);
///@}

}  // namespace pellucid::fields
