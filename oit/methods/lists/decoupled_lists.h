// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "oit/opacity/element_opacity.h"
#include "scene/opacity_energy.h"
#include "scene/renderer.h"

namespace pellucid::oit {

/// DecoupledListsOptions are those of the method `decoupled-lists`.
struct DecoupledListsOptions {
  scene::EnergyOptions energy;
  ElementOptions elements;

  bool operator==(const DecoupledListsOptions&) const = default;
};
/// Returns the table of DecoupledListsOptions.
const OptionTable<DecoupledListsOptions>& decoupled_lists_options();

/// Decoupled opacity optimization (Günther, Theisel and Gross 2017, "Decoupled
/// opacity optimization for points, lines and surfaces", CGF 36(2); equation
/// and section numbers of Baeza Rojo, Gross and Günther 2019, TVCG) as it is
/// there: exact sums of the importance from sorted lists of all fragments (Eq.
/// 2), the least opacity of each segment, patch or point, smoothed in object
/// space (section 2.2.4), and exact compositing by lists (Eq. 12).
/// `fourier-opacity` differs from it by its two series and by nothing else; the
/// method `decoupled` has neither elements nor smoothing.
///
/// The nodes of the lists are used twice: for the importance, then for the
/// colours.
///
/// Accuracy: exact for the opacities that it finds, up to coverage and float
/// rounding.
const scene::MethodRow& decoupled_lists_method();

}  // namespace pellucid::oit
