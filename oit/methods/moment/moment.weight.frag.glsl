// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/shapes/fragment.glsl"
#include "oit/methods/moment/moment_mass.glsl"
#include "oit/optical_depth/optical_weight.glsl"

uniform float clamp_alpha;

layout(location = 0) out vec4 sums;  // sum of C w, sum of w

void main() {
  Fragment f = fragment();
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec2 all = imageLoad(total, pixel).rg;
  float tau = all.r, of_nearest = all.g;
  if (tau <= 0.0) discard;  // nothing here has any opacity
  vec4 first = imageLoad(moments, pixel), last = vec4(0.0);
#if MOMENTS > 4
  last = imageLoad(more, pixel);
#endif
  float mass = mass_in_front_of(first, last, f.depth);
  float w = min(f.alpha, clamp_alpha) * transmittance_at(tau * (mass - of_nearest));
  sums = vec4(f.color * w, w);
}
