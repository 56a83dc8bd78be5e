#include "fragment.glsl"
#include "fourier_series.glsl"
#include "optical_weight.glsl"

uniform float clamp_alpha;
uniform float margin;  // of the series' period on either side of [0, 1]
// Two bands in a layer. An image, not a sampler: on llvmpipe a load costs a third of a texel fetch.
#if PRECISION == 16
layout(binding = 0, rgba16f) readonly uniform image2DArray coefficients;
#else
layout(binding = 0, rgba32f) readonly uniform image2DArray coefficients;
#endif

layout(location = 0) out vec4 sums;  // sum of C w, sum of w

float tau_at(float d) {
  vec2 one_band = first_wave(d);
  vec2 wave = vec2(1.0, 0.0);
  float tau = 0.0;
  for (int k = 0; k <= BANDS; k += 2) {
    vec4 c = imageLoad(coefficients, ivec3(gl_FragCoord.xy, k / 2));
    vec2 next_wave = add_angles(wave, one_band);
    tau += fourier_integral(k, c.xy, d, wave);
    if (k < BANDS) tau += fourier_integral(k + 1, c.zw, d, next_wave);
    wave = add_angles(next_wave, one_band);
  }
  return tau;
}

void main() {
  Fragment f = fragment();
  float d = (f.depth + margin) / (1.0 + 2.0 * margin);
  float alpha = min(f.alpha, clamp_alpha);
  float tau = tau_at(d);
  float w = MIDDLE == 1 ? optical_weight_middle(alpha, tau) : optical_weight(alpha, tau);
  sums = vec4(f.color * w, w);
}
