// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The energy of opacity optimization (Ament et al. 2017; Günther, Theisel and Gross 2017; equation
// numbers of Baeza Rojo, Gross and Günther 2019), in double: fragments of a pixel are independent.

#include <algorithm>
#include <array>
#include <cmath>

#include "core/options/parameters.h"

namespace pellucid::scene {

/// EnergyWeights are the parameters of the energy; without a unit.
struct EnergyWeights {
  double p = 1;       // keeps fragments opaque; > 0
  double q = 50;      // fades unimportant fragments in front of important ones; ≥ 0
  double r = 100;     // fades unimportant fragments behind important ones; ≥ 0
  double lambda = 2;  // how fast a fragment ceases to be important as g falls from 1; ≥ 0
};

/// Returns twice what multiplies α² in Eq. 1: `front` and `behind` are the sums of g_j² of what
/// lies in front of and behind the fragment of importance g.
inline double occlusion(const EnergyWeights& w, double g, double front, double behind) {
  return std::pow(1 - g, 2 * w.lambda) * (w.q * behind + w.r * front);
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

/// The weights p, q and r are at most this large: beyond the paper's by far, and safe in float.
inline constexpr double largest_weight = 1e12;

/// The rows for q, r, lambda and p belong in the table of a method that optimizes opacities; where
/// one is not given, the scene's counts.
inline constexpr auto energy_parameters = std::to_array<ParameterSpec>(
    {{.name = "q",
      .min = 0,
      .max = largest_weight,
      .help = "fades what is unimportant in front of what is important; the scene's, or 50"},
     {.name = "r",
      .min = 0,
      .max = largest_weight,
      .help = "fades what is unimportant behind what is important; the scene's, or 100"},
     {.name = "lambda",
      .min = 0,
      .max = 100,
      .help = "how fast a fragment ceases to be important as g falls from 1; the scene's, or 2"},
     {.name = "p",
      .min = 1e-12,
      .max = largest_weight,
      .help = "keeps fragments opaque; the scene's, or 1"}});

/// Returns the weights that `values` hold, and the scene's where they are not given.
inline EnergyWeights energy_weights(const Parameters& values, const EnergyWeights& of_scene) {
  const auto value = [&](std::string_view name, double otherwise) {
    return values.is_set(name) ? values.real(name) : otherwise;
  };
  return {value("p", of_scene.p), value("q", of_scene.q), value("r", of_scene.r),
          value("lambda", of_scene.lambda)};
}

}  // namespace pellucid::scene
