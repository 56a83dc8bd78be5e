#pragma once

#include "scene/renderer.h"

namespace pellucid {

/// Fourier-based compositing (Baeza Rojo, Gross and Guenther 2019, "Fourier opacity optimization
/// for scalable exploration", TVCG): the optical depth tau(d) of each pixel as a Fourier series
/// of `bands` frequencies, projected by additive blending (Eqs. 14, 16, 17), then sampled at each
/// fragment to weight its colour (Eq. 15), normalized (Eq. 19).
///
/// Opacities are clamped at `clamp` as in the paper: Eq. 13 divides by 1 - alpha. Beyond the paper:
/// -tau(d) is held in [-60, 60] before it is exponentiated, so that ringing over hundreds of nearly
/// opaque layers cannot leave the range of float.
///
/// Accuracy: the background's share is exact up to the clamp; exact for one layer when normalized;
/// otherwise no bound: it converges as bands grow, like 1 / bands at a step.
const MethodRow& fourier_method();

}  // namespace pellucid
