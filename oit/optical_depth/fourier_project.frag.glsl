// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/shapes/fragment.glsl"
#include "oit/optical_depth/fourier_sample.glsl"
#include "oit/optical_depth/optical_depth.glsl"

uniform float clamp_alpha;
uniform float margin;  // of the series' period on either side of [0, 1]

layout(location = 0) out vec4 coefficients[TARGETS];  // two bands each, from FIRST_BAND on

void main() {
  Fragment f = fragment();
#ifdef PROJECT_IMPORTANCE
  float impulse = importance().x * importance().x;  // of G, Eq. 11
#else
  float impulse = optical_depth(min(f.alpha, clamp_alpha));  // of tau, Eqs. 16 and 17
#endif
  impulse *= float(SUBSET);
  vec2 one_band = first_wave(place_in_period(f.depth, margin));
  vec2 wave = vec2(1.0, 0.0);
  for (int k = 0; k < FIRST_BAND; ++k) wave = add_angles(wave, one_band);
  for (int target = 0; target < TARGETS; ++target) {
    vec2 next_wave = add_angles(wave, one_band);
    coefficients[target] =
        vec4(fourier_project(impulse, wave), fourier_project(impulse, next_wave));
    wave = add_angles(next_wave, one_band);
  }
}
