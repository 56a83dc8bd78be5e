// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "oit/optical_depth/optical_depth_passes.h"

namespace pellucid::oit {

/// How tau is read within a bin.
enum class BinMode { constant, linear };

/// BinningOptions are those of the method `binning`.
struct BinningOptions {
  int bins = 11;  // equal parts of the depth range, 1 to 1024
  BinMode mode = BinMode::linear;
  bool normalize = true;       // by Eq. 19
  double clamp = usual_clamp;  // largest opacity, below 1: Eq. 13 divides by 1 - alpha

  bool operator==(const BinningOptions&) const = default;
};
/// Returns the table of BinningOptions.
const OptionTable<BinningOptions>& binning_options();

/// Binning of the optical depth (Baeza Rojo, Gross and Guenther 2019, section 5.3, and section 2.2
/// of its additional material): tau(d) of each pixel as a sum over equal bins of depth, in place of
/// the Fourier series; weights and normalization are those of `fourier` (Eqs. 14, 15, 19).
///
/// mode=linear interpolates tau between the edges of a bin; mode=constant takes its value at the
/// far edge, which shows as steps at the bins' boundaries.
///
/// Fragments are added to their bin by an atomic exchange, so that any number of bins takes one
/// pass, where blending would take one for every 32.
///
/// Accuracy: the background's share is exact up to the clamp; exact for one layer and for layers
/// in bins of their own; no bound otherwise.
const scene::MethodRow& binning_method();

}  // namespace pellucid::oit
