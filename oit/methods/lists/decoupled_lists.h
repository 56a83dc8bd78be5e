// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "oit/lists/list_options.h"
#include "oit/opacity/element_opacity.h"
#include "scene/opacity_energy.h"
#include "scene/renderer.h"

namespace pellucid::oit {

/// DecoupledListsOptions are those of the method `decoupled-lists`.
struct DecoupledListsOptions {
  scene::EnergyOptions energy;
  OpacityUnit per = OpacityUnit::element;
  ElementOptions elements;
  ListOptions lists;

  bool operator==(const DecoupledListsOptions&) const = default;
};
/// Returns the table of DecoupledListsOptions.
const OptionTable<DecoupledListsOptions>& decoupled_lists_options();

/// Decoupled opacity optimization (Günther, Theisel and Gross 2017, "Decoupled opacity optimization
/// for points, lines and surfaces", CGF 36(2); equation and section numbers of Baeza Rojo, Gross
/// and Günther 2019, TVCG) as it is there: exact sums of the importance from sorted lists of all
/// fragments (Eq. 2), the least opacity of each segment, patch or point, smoothed in object space
/// (section 2.2.4), and exact compositing by lists (Eq. 12). `fourier-opacity` differs from it by
/// its two series and by nothing else.
///
/// The nodes of the lists are used twice: for the elements, then for the colours. `per=fragment`
/// leaves elements and smoothing out, as in the paper's comparison of importance (Fig. 6): the
/// opacities are found while the lists, made once, are composited. Those of the method `decoupled`
/// are the same, in double.
///
/// Accuracy: exact for the opacities that it finds, up to coverage and float rounding.
const scene::MethodRow& decoupled_lists_method();

}  // namespace pellucid::oit
