// SPDX-License-Identifier: GPL-3.0-or-later
// What the moments of a pixel say is the same for all its fragments: it is found once.
#include "oit/methods/moment/moment_mass.glsl"
#include "oit/optical_depth/nearness.glsl"
#include "oit/optical_depth/optical_weight.glsl"

uniform float bias;

// Moved a little towards those of a distribution with mass in the whole interval (the supplement's
// vectors; the circle's uniform one), so that rounding cannot leave the set of moments.
void move_inwards(inout vec4 b, inout vec4 c) {
#ifdef TRIGONOMETRIC
  b *= 1.0 - bias;
  c *= 1.0 - bias;
#elif MOMENTS == 4
  b = mix(b, vec4(0.0, 0.375, 0.0, 0.375), bias);
#elif MOMENTS == 6
  b = mix(b, vec4(0.0, 0.48, 0.0, 0.451), bias);
  c = mix(c, vec4(0.0, 0.45, 0.0, 0.0), bias);
#else
  b = mix(b, vec4(0.0, 0.75, 0.0, 203.0 / 300.0), bias);
  c = mix(c, vec4(0.0, 0.63, 0.0, 1981.0 / 3300.0), bias);
#endif
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec2 sums = imageLoad(total, pixel).rg;
  float tau = sums.r;
  if (tau <= 0.0) return;  // nothing here has any opacity
  vec4 b = imageLoad(moments, pixel) / tau, c = vec4(0.0);
#if MOMENTS > 4
  c = imageLoad(more, pixel) / tau;
#endif
  move_inwards(b, c);
#ifndef TRIGONOMETRIC
  float all[9] = float[9](1.0, b.x, b.y, b.z, b.w, c.x, c.y, c.z, c.w);
  Recurrence r = recurrence_of(all, MOMENTS / 2);
  b = vec4(r.a.xy, r.b.xy);
  c = vec4(r.a.z, r.b.z, r.a.w, r.b.w);
#endif
  // What the nearest fragment is taken for (a share of the mass at it counts as in front of it) is
  // a factor of all weights, by which their mean does not change: without it those of hundreds of
  // nearly opaque layers are the same number, the smallest that there is.
  float of_nearest = tau > largest_tau ? mass_in_front_of(b, c, nearest_depth(sums.g)) : 0.0;
  imageStore(total, pixel, vec4(tau, of_nearest, 0.0, 0.0));
  imageStore(moments, pixel, b);
#if MOMENTS > 4
  imageStore(more, pixel, c);
#endif
}
