// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "integrators/front/surface_particles.h"

namespace pellucid::integrators {

/// A seed curve is looked at in so many intervals of s, and particles are followed from its ends
/// and so many places: what is narrower may be missed.
///@{
inline constexpr int seed_looks = 1024;
inline constexpr int followed_looks = 64;
///@}

/// Returns places s in (0, 1), ascending, at which a front needs particles beside `seeds`, which
/// ascend from 0 to 1, so as not to step over a feature of the field: where its velocity along the
/// seed curve at the start time is off the straight line between its neighbours' by more than a
/// quarter of the largest speed on the curve; and one in each stretch of the curve that has none
/// and in which the field is there, or is not, or from which particles last for the whole duration,
/// or do not.
std::vector<double> seed_features(const SurfaceRequest& request, const SurfaceSetup& setup,
                                  std::span<const double> seeds);

}  // namespace pellucid::integrators
