// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef IMPORTANCE_SERIES
#define IMPORTANCE_SERIES
// The importance G(d) of a pixel as a Fourier series (Eq. 11 of Baeza Rojo et al. 2019), and the
// opacity of a fragment by it (Eq. 10).
#include "oit/optical_depth/fourier_sample.glsl"
#include "oit/opacity/energy.glsl"

#if IMPORTANCE_PRECISION == 16
layout(binding = importance_image, rgba16f) readonly uniform image2DArray importance_coefficients;
#else
layout(binding = importance_image, rgba32f) readonly uniform image2DArray importance_coefficients;
#endif
ivec2 importance_pixel() { return ivec2(gl_FragCoord.xy) / PIXELS_PER_SERIES; }
FOURIER_SUM(importance_sum, importance_coefficients, IMPORTANCE_BANDS, importance_pixel())

// `g`: the importance and 1 minus it.
float opacity_by_series(vec2 g, float depth) {
  float total = 0.5 * imageLoad(importance_coefficients, ivec3(importance_pixel(), 0)).r;  // Eq. 7
  float sum = importance_sum(place_in_period(depth, importance_margin));
  float own = g.x * g.x;
  return optimal_opacity(energy_weights, g.y, sum - own_share * own,
                         total - sum - (1.0 - own_share) * own);
}
#endif
