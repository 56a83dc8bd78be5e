// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The energy of opacity optimization (Ament et al. 2017; Günther, Theisel and Gross 2017; equation
// numbers of Baeza Rojo, Gross and Günther 2019), in double: fragments of a pixel are independent.

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/options/option_table.h"

namespace pellucid::scene {

/// EnergyWeights are the parameters of the energy; without a unit.
struct EnergyWeights {
  double p = 1;       // keeps fragments opaque; > 0
  double q = 50;      // fades unimportant fragments in front of important ones; ≥ 0
  double r = 100;     // fades unimportant fragments behind important ones; ≥ 0
  double lambda = 2;  // how fast a fragment ceases to be important as g falls from 1; ≥ 0
};

/// Returns twice what multiplies α² in Eq. 1: `front` and `behind` are the sums of g_j² of what
/// lies in front of and behind the fragment of importance g. An importance that rounding left above
/// 1 counts as 1.
inline double occlusion(const EnergyWeights& w, double g, double front, double behind) {
  return std::pow(std::max(1 - g, 0.0), 2 * w.lambda) * (w.q * behind + w.r * front);
}

/// Returns E_i(α) of Eq. 1, except that there q and r stand by the other's sum: Eq. 2 (and 10),
/// which the paper derives from it, and its description of the weights have q with what lies
/// behind.
inline double energy(const EnergyWeights& w, double alpha, double g, double front, double behind) {
  return 0.5 * w.p * (alpha - 1) * (alpha - 1) +
         0.5 * alpha * alpha * occlusion(w, g, front, behind);
}

/// Returns the opacity in [0, 1] of least energy, Eq. 2. Sums that a series makes negative count as
/// 0.
inline double optimal_opacity(const EnergyWeights& w, double g, double front, double behind) {
  return w.p / (w.p + occlusion(w, g, std::max(front, 0.0), std::max(behind, 0.0)));
}

/// EnergyOptions are the weights that are given; the others are those of the scene. Ranges as of
/// EnergyWeights.
struct EnergyOptions {
  std::optional<double> q, r, lambda, p;

  bool operator==(const EnergyOptions&) const = default;
};

/// The table for a method that optimizes opacities, and for a scene's `energy`.
const OptionTable<EnergyOptions>& energy_options();

/// Returns the weights that are given, and the scene's where they are not.
inline EnergyWeights energy_weights(const EnergyOptions& given, const EnergyWeights& of_scene) {
  return {given.p.value_or(of_scene.p), given.q.value_or(of_scene.q), given.r.value_or(of_scene.r),
          given.lambda.value_or(of_scene.lambda)};
}

}  // namespace pellucid::scene
