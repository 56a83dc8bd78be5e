// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "oit/optical_depth/optical_depth_passes.h"

namespace pellucid::oit {

/// A MomentBasis says what the moments are of.
enum class MomentBasis {
  power,         // powers of depth
  trigonometric  // cosines and sines of multiples of an angle
};

/// MomentOptions are those of the method `moment`.
struct MomentOptions {
  int moments = 4;  // numbers beyond the zeroth moment: 4, 6 or 8
  MomentBasis basis = MomentBasis::power;
  std::optional<double> bias;    // share of a safe distribution; not set: by basis and number
  double overestimation = 0.25;  // share of the mass at a fragment that counts as in front of it
  double clamp = usual_clamp;    // largest opacity, below 1

  bool operator==(const MomentOptions&) const = default;
};
/// Returns the table of MomentOptions.
const OptionTable<MomentOptions>& moment_options();

/// Moment-based order-independent transparency (Muenstermann, Krumpen, Klein and Peters 2018,
/// PACMCGIT 1(1)) with 4, 6 or 8 power or 2, 3 or 4 trigonometric moments: the distribution of
/// optical depth over depth is kept as its moments, from which the transmittance in front of a
/// fragment is reconstructed; colours weighted by it are normalized.
///
/// What differs from the paper: z = 2 d - 1 is linear in depth, where the paper takes a logarithm;
/// moments are 32-bit floats.
///
/// Accuracy: the background's share is exact up to the clamp; exact for one layer; otherwise no
/// bound. With m numbers the reconstruction is exact, up to the bias, in front of, between and
/// behind m / 2 layers, and at a layer within the overestimation's choice.
const scene::MethodRow& moment_method();

}  // namespace pellucid::oit
