#include "fragment.glsl"
#include "optical_depth.glsl"
#include "fourier_series.glsl"

uniform float clamp_alpha;

layout(location = 0) out vec4 coefficients[TARGETS];

// Coefficient i lies in component i % 4 of target i / 4.
void main() {
  Fragment f = fragment();
  float c[FOURIER_COEFFICIENTS];
  fourier_project(optical_depth(min(f.alpha, clamp_alpha)), f.depth, c);
  for (int target = 0; target < TARGETS; ++target) {
    vec4 v = vec4(0.0);
    for (int i = 0; i < 4; ++i)
      if (4 * target + i < FOURIER_COEFFICIENTS) v[i] = c[4 * target + i];
    coefficients[target] = v;
  }
}
