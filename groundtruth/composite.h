#pragma once

#include <span>

#include "groundtruth/crossing_finder.h"

namespace pellucid {

/// Front-to-back composite of `crossings` (sorted) over the background,
///   C = Σ C_i α_i Π_{j<i} (1 - α_j) + C_bg Π (1 - α_i)
/// (Baeza Rojo et al. 2019, Eq. 12), in double. Returns colour and transmittance.
struct Composite {
  Vec3 color;
  double transmittance;
};
Composite composite(const CrossingFinder& finder, std::span<const Crossing> crossings,
                    const Vec3& background, const Vec3& world_direction);

}  // namespace pellucid
