// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "oit/optical_depth/optical_depth_passes.h"
#include "oit/stage/oit_renderer.h"

namespace pellucid::oit {

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

/// Of the series of tau, and of the passes that use it.
inline constexpr auto fourier_parameters = std::to_array<ParameterSpec>(
    {{.name = "bands",
      .kind = ParameterSpec::Kind::integer,
      .default_value = "5",
      .min = 1,
      .max = 64,
      .unit = "bands",
      .help =
          "frequencies of the series (m in the paper); beyond 15 each 16 more take another pass"},
     normalize_parameter,
     clamp_parameter,
     {.name = "at",
      .kind = ParameterSpec::Kind::choice,
      .default_value = "behind",
      .choices = "behind|middle",
      .help = "where the series is taken to be at a fragment: behind it as in Eq. 15, or in the "
              "middle of its step, whither a series converges"},
     {.name = "margin",
      .kind = ParameterSpec::Kind::real,
      .default_value = "0",
      .min = 0,
      .max = 1,
      .unit = "depth ranges",
      .help = "what the series' period exceeds the depth range by on either side; at 0 the nearest "
              "and the farthest depth are one and the same to it"},
     {.name = "precision",
      .kind = ParameterSpec::Kind::choice,
      .default_value = "32",
      .unit = "bits",
      .choices = "32|16",
      .help = "of a coefficient"},
     {.name = "subset",
      .kind = ParameterSpec::Kind::integer,
      .default_value = "1",
      .min = 1,
      .max = 1e6,
      .unit = "primitives",
      .help = "project every n-th triangle, segment and point only, n-fold (section 5.5.3)"}});

/// The method as the last steps of another one, of fragments with these opacities.
std::unique_ptr<OitMethod> make_fourier(Stage& stage, const Parameters& parameters,
                                        const FragmentOpacity& opacity);

}  // namespace pellucid::oit
