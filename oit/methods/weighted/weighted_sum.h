// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/options/option_table.h"
#include "scene/renderer.h"

namespace pellucid::oit {

/// WeightedSumOptions are those of the method `weighted-sum`.
struct WeightedSumOptions {
  bool clamp = true;  // to [0, 1]

  bool operator==(const WeightedSumOptions&) const = default;
};
/// Returns the table of WeightedSumOptions.
const OptionTable<WeightedSumOptions>& weighted_sum_options();

/// Weighted sum (Meshkin 2007, "Sort-independent alpha blending", GDC): the terms of the composite
/// that do not depend on the order, to first order in the opacities.
///
///   C = sum alpha_i C_i + C_bg (1 - sum alpha_i)
///
/// `clamp`: the picture is held in [0, 1], as the 8-bit frame buffers that it was made for do.
///
/// Accuracy: exact for one layer; the error is of second order in the opacities, so that it is of
/// use for few layers of low opacity only.
const scene::MethodRow& weighted_sum_method();

}  // namespace pellucid::oit
