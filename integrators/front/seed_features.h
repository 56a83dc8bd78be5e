// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
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

/// SeedFeatures are places s on a seed curve, and what it took to find them.
struct SeedFeatures {
  std::vector<double> seeds;      // ascending, in (0, 1)
  std::uint64_t evaluations = 0;  // of the field
};

/// Returns the places at which a front needs particles beside `seeds`, which
/// ascend from 0 to 1, so as not to step over a feature of the field: where its velocity along the
/// seed curve at the start time is off the straight line between its neighbours' by more than a
/// quarter of the largest speed on the curve; one in each stretch of the curve that has none and in
/// which the field is there, or is not; and on both sides of where the surface's border jumps:
/// where particles begin to end by another reason, or at another time by more than `shortest_edge`
/// of `setup` at their speed, as past an obstacle; and where that border has corners.
SeedFeatures seed_features(const SurfaceRequest& request, const SurfaceSetup& setup,
                           std::span<const double> seeds);

}  // namespace pellucid::integrators
