#include "fragment.glsl"
#include "optical_weight.glsl"
#include "power_moments.glsl"

uniform float clamp_alpha, bias, overestimation;
// Images, not samplers: on llvmpipe a load costs a third of a texel fetch.
layout(binding = 0, r32f) readonly uniform image2D total;
layout(binding = 1, rgba32f) readonly uniform image2D moments;
layout(binding = 2, rg32f) readonly uniform image2D more;

layout(location = 0) out vec4 sums;  // sum of C w, sum of w

// Moments of a distribution, moved a little towards those of one with mass in the whole interval
// (the supplement's vectors), so that rounding cannot leave the set of moments.
float mass_in_front(ivec2 pixel, float tau, float z) {
  vec4 b = imageLoad(moments, pixel) / tau;
#if MOMENTS == 6
  vec2 c = imageLoad(more, pixel).xy / tau;
  b = mix(b, vec4(0.0, 0.48, 0.0, 0.451), bias);
  return mass_in_front_6(b, mix(c, vec2(0.0, 0.45), bias), z, overestimation);
#else
  b = mix(b, vec4(0.0, 0.375, 0.0, 0.375), bias);
  return mass_in_front_4(b, z, overestimation);
#endif
}

void main() {
  Fragment f = fragment();
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float tau = imageLoad(total, pixel).r;
  if (tau <= 0.0) discard;  // nothing here has any opacity
  float mass = clamp(mass_in_front(pixel, tau, 2.0 * f.depth - 1.0), 0.0, 1.0);
  float w = min(f.alpha, clamp_alpha) * transmittance_at(tau * mass);
  sums = vec4(f.color * w, w);
}
