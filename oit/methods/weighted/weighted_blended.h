// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/options/option_table.h"
#include "scene/renderer.h"

namespace pellucid::oit {

/// WeightedBlendedOptions are those of the method `weighted-blended`.
struct WeightedBlendedOptions {
  int weight = 10;  // number of the weight's equation, 7 to 10; 0: w = 1

  bool operator==(const WeightedBlendedOptions&) const = default;
};
/// Returns the table of WeightedBlendedOptions.
const OptionTable<WeightedBlendedOptions>& weighted_blended_options();

/// Weighted blended order-independent transparency (McGuire and Bavoil 2013, JCGT 2(2)): a weighted
/// mean colour over the background's exact transmittance, the weight falling with depth.
///
///   C = (sum alpha_i C_i w_i / sum alpha_i w_i) (1 - T) + C_bg T,  T = product (1 - alpha_i)
///
/// `weight` is the number of the weight's equation in the paper, 7 to 10, or "none" for w = 1.
/// Equations 7 to 9 were made for view depths of 0.1 to 500; the scenes here have no such unit, so
/// that d in [0, 1] is mapped linearly onto that range. Equation 10 takes d itself, where the paper
/// takes the nonlinear depth of OpenGL.
///
/// Accuracy: the background's share is exact; the colour is exact for one layer and for layers of
/// one colour; no bound otherwise.
const scene::MethodRow& weighted_blended_method();

}  // namespace pellucid::oit
