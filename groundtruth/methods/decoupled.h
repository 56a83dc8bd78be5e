// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/opacity_energy.h"
#include "scene/renderer.h"

namespace pellucid::groundtruth {

/// DecoupledOptions are those of the method `decoupled`.
struct DecoupledOptions {
  scene::EnergyOptions energy;
  int bands = 0;  // of the Fourier series that gives G(d), at most 64; 0: the exact sums

  bool operator==(const DecoupledOptions&) const = default;
};
/// Returns the table of DecoupledOptions.
const OptionTable<DecoupledOptions>& decoupled_options();

/// Decoupled opacity optimization (Günther, Theisel and Gross 2017, "Decoupled opacity optimization
/// for points, lines and surfaces", CGF 36(2); equation numbers of Baeza Rojo, Gross and Günther
/// 2019, TVCG) over all crossings of a pixel's ray, in double: each fragment's opacity is the one
/// of least energy (Eqs. 1, 2, 10), then all are composited exactly (Eq. 12). `bands` above 0 takes
/// G(d) from a Fourier series of so many bands (Eq. 11) instead of the exact sums, and nothing
/// else: what differs is what the series does to the importance.
///
/// The opacities are those of the pixel: no minimum over segments and no smoothing in object space,
/// as in the paper's own comparison of importance (section 5.2).
///
/// Beyond the paper: the optimal opacity is multiplied by the scene's own. Scenes there are opaque.
/// Where nothing is important every fragment keeps its own opacity: the energy is least at 1.
/// Objects without importance are context, g = 0; opaque objects stay as they are.
///
/// Accuracy: exact up to double rounding; with `bands`, a series converges at a fragment to the
/// middle of its own step, while Eq. 10 wants the value behind it.
const scene::MethodRow& decoupled_method();

}  // namespace pellucid::groundtruth
