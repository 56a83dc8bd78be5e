// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "oit/optical_depth/fourier_projection.h"
#include "oit/stage/oit_renderer.h"

namespace pellucid::oit {

/// FourierOptions are those of the method `fourier`.
struct FourierOptions {
  int bands = 5;          // frequencies of the series, 1 to 64 (m in the paper)
  bool normalize = true;  // by Eq. 19
  SeriesOptions series;   // of tau

  bool operator==(const FourierOptions&) const = default;
};
/// Returns the table of FourierOptions.
const OptionTable<FourierOptions>& fourier_options();

/// Fourier-based compositing (Baeza Rojo, Gross and Guenther 2019, "Fourier opacity optimization
/// for scalable exploration", TVCG): the optical depth tau(d) of each pixel as a Fourier series
/// of `bands` frequencies, projected by additive blending (Eqs. 14, 16, 17), then sampled at each
/// fragment to weight its colour (Eq. 15), normalized (Eq. 19).
///
/// Opacities are clamped at `clamp` as in the paper: Eq. 13 divides by 1 - alpha. Beyond the paper:
/// -tau(d) is held in [-60, 60] before it is exponentiated, so that ringing over hundreds of nearly
/// opaque layers cannot leave the range of float.
///
/// Erratum: the paper says that Eq. 19 converges to the exact composite as bands grow. tau has a
/// step at every fragment, where Eq. 15 wants the value behind the step; a Fourier series converges
/// to the middle of it. The limit is therefore exact only where all opacities of a pixel are equal.
/// at=middle reads the series as the middle and weights by alpha / sqrt(1 - alpha) accordingly: it
/// does converge. The default is the paper's.
///
/// Accuracy: the background's share is exact up to the clamp; exact for one layer when normalized;
/// otherwise no bound: the error of tau falls like 1 / bands away from the steps.
const scene::MethodRow& fourier_method();

/// The method as the last steps of another one, of fragments with these opacities.
std::unique_ptr<OitMethod> make_fourier(Stage& stage, const FourierOptions& options,
                                        const FragmentOpacity& opacity);

}  // namespace pellucid::oit
