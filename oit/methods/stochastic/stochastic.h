// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/options/option_table.h"
#include "scene/renderer.h"

namespace pellucid::oit {

/// StochasticOptions are those of the method `stochastic`.
struct StochasticOptions {
  int samples = 16;  // passes over the scene, 1 to 4096
  int seed = 0;      // of the random numbers, from 0; a study's further draws are those of the next

  bool operator==(const StochasticOptions&) const = default;
};
/// Returns the table of StochasticOptions.
const OptionTable<StochasticOptions>& stochastic_options();

/// Stochastic transparency with alpha correction (Enderton, Sintorn, Shirley and Luebke 2010,
/// I3D): each of S samples draws a fragment with the probability of its opacity and keeps the
/// nearest; the mean colour of the samples goes over the exact transmittance of the background.
///
/// What differs from the paper: a sample is a pass of its own at the pixel's centre, not one of a
/// multisampled target, so that S is free; the random numbers are a hash of seed, pixel, sample
/// and depth, so that neither a frame nor an order of submission changes them; a pixel that no
/// sample hits takes the weighted average of its fragments' colours, where the paper has none.
///
/// Accuracy: unbiased but for the correction; the standard deviation falls like 1 / sqrt(S). The
/// background's share is exact, and so is one layer.
const scene::MethodRow& stochastic_method();

}  // namespace pellucid::oit
