// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/vec.h"

namespace pellucid::groundtruth {

/// The composite of layers that are added from front to back, in double:
///   C = Σ C_i α_i Π_{j<i} (1 - α_j) + C_bg Π (1 - α_i)
/// (Baeza Rojo et al. 2019, Eq. 12). oit/stage/front_to_back.glsl is the same in float.
struct FrontToBack {
  Vec3 color{0};             // of the layers so far
  double transmittance = 1;  // of all of them; rounding may take that of α = 1 an ulp below 0

  /// Adds a layer of straight colour and of opacity `alpha` in [0, 1] behind all others.
  void add(const Vec3& layer_color, double alpha) {
    color += transmittance * alpha * layer_color;
    transmittance *= 1 - alpha;
  }
  /// The colour with the background behind it.
  Vec3 over(const Vec3& background) const { return color + transmittance * background; }
};

}  // namespace pellucid::groundtruth
