// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FOURIER_SAMPLE
#define FOURIER_SAMPLE
#include "oit/optical_depth/fourier_series.glsl"

// float NAME(float d): the integral up to d in [0, 1] (Eq. 5) of the series that a PIXEL has in the
// image array COEFFICIENTS, two bands in a layer. An image, not a sampler: on llvmpipe a load costs
// a third of a texel fetch.
#define FOURIER_SUM(name, coefficients, bands, pixel)                     \
  float name(float d) {                                                   \
    vec2 one_band = first_wave(d);                                        \
    vec2 wave = vec2(1.0, 0.0);                                           \
    float sum = 0.0;                                                      \
    for (int k = 0; k <= bands; k += 2) {                                 \
      vec4 c = imageLoad(coefficients, ivec3(pixel, k / 2));              \
      vec2 next_wave = add_angles(wave, one_band);                        \
      sum += fourier_integral(k, c.xy, d, wave);                          \
      if (k < bands) sum += fourier_integral(k + 1, c.zw, d, next_wave);  \
      wave = add_angles(next_wave, one_band);                             \
    }                                                                     \
    return sum;                                                           \
  }

// A depth as the series' place in its period, which exceeds [0, 1] by `margin` on either side.
float place_in_period(float depth, float margin) {
  return (depth + margin) / (1.0 + 2.0 * margin);
}
#endif
