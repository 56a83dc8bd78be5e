#pragma once

#include <span>

#include "groundtruth/crossing_finder.h"
#include "scene/scene.h"

namespace pellucid {

/// A crossing's colour (lit, not premultiplied) and opacity.
struct Fragment {
  Vec3 color;
  double opacity;
};

/// Interpolates the triangle's vertex colours at the crossing, in double, and lights them:
/// Lighting::headlight multiplies by |n · v|, n the normalised interpolation of the vertex normals
/// (both sides alike), v the direction to the eye.
Fragment shade(const Scene& scene, const Crossing& crossing, const Vec3& ray_direction);

/// Front-to-back composite of `crossings` (sorted) over the background,
///   C = Σ C_i α_i Π_{j<i} (1 - α_j) + C_bg Π (1 - α_i)
/// (Baeza Rojo et al. 2019, Eq. 12), in double. Returns colour and transmittance.
struct Composite {
  Vec3 color;
  double transmittance;
};
Composite composite(const Scene& scene, std::span<const Crossing> crossings,
                    const Vec3& ray_direction);

}  // namespace pellucid
