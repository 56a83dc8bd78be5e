#include "fragment.glsl"
#include "fourier_series.glsl"

uniform float clamp_alpha;
layout(binding = 0) uniform sampler2DArray coefficients;

layout(location = 0) out vec4 sums;  // sum of C w, sum of w

void main() {
  Fragment f = fragment();
  float c[FOURIER_COEFFICIENTS];
  for (int target = 0; target < TARGETS; ++target) {
    vec4 v = texelFetch(coefficients, ivec3(gl_FragCoord.xy, target), 0);
    for (int i = 0; i < 4; ++i)
      if (4 * target + i < FOURIER_COEFFICIENTS) c[4 * target + i] = v[i];
  }
  float alpha = min(f.alpha, clamp_alpha);
  float tau = fourier_integral(f.depth, c);
  float w = alpha / (1.0 - alpha) * exp(clamp(-tau, -60.0, 60.0));  // Eq. 15
  sums = vec4(f.color * w, w);
}
