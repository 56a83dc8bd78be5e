// SPDX-License-Identifier: GPL-3.0-or-later
// What a pixel keeps of its moments between the passes over the scene, and the share of its optical
// depth in front of a depth. In the place of the sums there are then
//   total          tau; what the mass in front of the nearest fragment is taken for
//   moments, more  the recurrence: a_0, a_1, b_1, b_2; a_2, b_3, a_3, b_4;
//                  of trigonometric moments these themselves, of a distribution of mass 1
#include "oit/gl/bindings.glsl"
#ifdef TRIGONOMETRIC
#include "oit/optical_depth/trigonometric_moments.glsl"
uniform float angle_range;  // of the depths; the rest of a turn is between the last and the first
#else
#include "oit/optical_depth/power_moments.glsl"
#endif

uniform float overestimation;
// Images, not samplers: on llvmpipe a load costs a third of a texel fetch.
layout(binding = coefficients_image, rg32f) uniform image2D total;
layout(binding = coefficients_image + 1, rgba32f) uniform image2D moments;
#if MOMENTS == 6
layout(binding = coefficients_image + 2, rg32f) uniform image2D more;
#else
layout(binding = coefficients_image + 2, rgba32f) uniform image2D more;
#endif

float mass_in_front_of(vec4 first, vec4 last, float d) {
#ifdef TRIGONOMETRIC
  TrigonometricMoments m;
  m.b[0] = vec2(1.0, 0.0);
  m.b[1] = first.xy;
  m.b[2] = first.zw;
  m.b[3] = last.xy;
  m.b[4] = last.zw;
  float mass = mass_in_front_of_angle(m, MOMENTS / 2, angle_range * d, angle_range, overestimation);
#else
  Recurrence r = Recurrence(vec4(first.xy, last.x, last.z), vec4(first.zw, last.y, last.w));
  float mass = mass_in_front(r, MOMENTS / 2, 2.0 * d - 1.0, overestimation);
#endif
  return clamp(mass, 0.0, 1.0);
}
