// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "groundtruth/traversal/crossing_finder.h"

namespace pellucid::groundtruth {

/// Colour, the background's share and the number of crossings composited.
struct Composite {
  Vec3 color;
  double transmittance;
  std::uint32_t layers;
};

/// Composites `crossings`, which are sorted from front to back, over the background in double
/// (Baeza Rojo et al. 2019, Eq. 12; see FrontToBack). It ends where the transmittance falls below
/// `stop_below`; what lies behind then counts as background, so that, colours within [0, 1], each
/// channel errs by less than `stop_below`. `world_direction` is the ray's, of any length.
Composite composite(const CrossingFinder& finder, std::span<const Crossing> crossings,
                    const Vec3& background, const Vec3& world_direction, double stop_below = 0);

}  // namespace pellucid::groundtruth
