// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/shapes/fragment.glsl"
#include "oit/optical_depth/nearness.glsl"
#include "oit/optical_depth/optical_weight.glsl"
#ifdef TRIGONOMETRIC
#include "oit/optical_depth/trigonometric_moments.glsl"
uniform float angle_range;
#else
#include "oit/optical_depth/power_moments.glsl"
#endif

uniform float clamp_alpha, bias, overestimation;
// Images, not samplers: on llvmpipe a load costs a third of a texel fetch.
layout(binding = coefficients_image, rg32f) readonly uniform image2D total;
layout(binding = coefficients_image + 1, rgba32f) readonly uniform image2D moments;
#if MOMENTS == 6
layout(binding = coefficients_image + 2, rg32f) readonly uniform image2D more;
#else
layout(binding = coefficients_image + 2, rgba32f) readonly uniform image2D more;
#endif

layout(location = 0) out vec4 sums;  // sum of C w, sum of w

// Moments of a distribution, moved a little towards those of one with mass in the whole interval
// (the supplement's vectors; the circle's uniform one), so that rounding cannot leave the set of
// moments.
float reconstructed_mass(vec4 b, vec4 c, float d) {
#ifdef TRIGONOMETRIC
  TrigonometricMoments m;
  m.b[0] = vec2(1.0, 0.0);
  m.b[1] = (1.0 - bias) * b.xy;
  m.b[2] = (1.0 - bias) * b.zw;
  m.b[3] = (1.0 - bias) * c.xy;
  m.b[4] = (1.0 - bias) * c.zw;
  return mass_in_front_of_angle(m, MOMENTS / 2, angle_range * d, angle_range, overestimation);
#else
#if MOMENTS == 4
  b = mix(b, vec4(0.0, 0.375, 0.0, 0.375), bias);
#elif MOMENTS == 6
  b = mix(b, vec4(0.0, 0.48, 0.0, 0.451), bias);
  c = mix(c, vec4(0.0, 0.45, 0.0, 0.0), bias);
#else
  b = mix(b, vec4(0.0, 0.75, 0.0, 203.0 / 300.0), bias);
  c = mix(c, vec4(0.0, 0.63, 0.0, 1981.0 / 3300.0), bias);
#endif
  float all[9] = float[9](1.0, b.x, b.y, b.z, b.w, c.x, c.y, c.z, c.w);
  return mass_in_front(all, MOMENTS / 2, 2.0 * d - 1.0, overestimation);
#endif
}

void main() {
  Fragment f = fragment();
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec2 all = imageLoad(total, pixel).rg;
  float tau = all.r;
  if (tau <= 0.0) discard;  // nothing here has any opacity
  vec4 b = imageLoad(moments, pixel) / tau, c = vec4(0.0);
#if MOMENTS > 4
  c = imageLoad(more, pixel) / tau;
#endif
  float mass = clamp(reconstructed_mass(b, c, f.depth), 0.0, 1.0);
  // What the nearest fragment is taken for (a share of the mass at it counts as in front of it) is
  // a factor of all weights, by which their mean does not change: without it those of hundreds of
  // nearly opaque layers are the same number, the smallest that there is.
  float of_nearest = 0.0;
  if (tau > largest_tau)
    of_nearest = clamp(reconstructed_mass(b, c, nearest_depth(all.g)), 0.0, 1.0);
  float w = min(f.alpha, clamp_alpha) * transmittance_at(tau * (mass - of_nearest));
  sums = vec4(f.color * w, w);
}
