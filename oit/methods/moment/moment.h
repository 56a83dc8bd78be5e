// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/renderer.h"

namespace pellucid::oit {

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
