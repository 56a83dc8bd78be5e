#include "fragment.glsl"
#include "optical_depth.glsl"
#include "fourier_series.glsl"

uniform float clamp_alpha;
uniform float margin;  // of the series' period on either side of [0, 1]

layout(location = 0) out vec4 coefficients[TARGETS];  // two bands each, from FIRST_BAND on

void main() {
  Fragment f = fragment();
  float d = (f.depth + margin) / (1.0 + 2.0 * margin);
  float tau = float(SUBSET) * optical_depth(min(f.alpha, clamp_alpha));
  vec2 one_band = first_wave(d);
  vec2 wave = vec2(1.0, 0.0);
  for (int k = 0; k < FIRST_BAND; ++k) wave = add_angles(wave, one_band);
  for (int target = 0; target < TARGETS; ++target) {
    vec2 next_wave = add_angles(wave, one_band);
    coefficients[target] = vec4(fourier_project(tau, wave), fourier_project(tau, next_wave));
    wave = add_angles(next_wave, one_band);
  }
}
