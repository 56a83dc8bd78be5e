// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/shapes/fragment.glsl"
#include "oit/optical_depth/nearness.glsl"
#include "oit/optical_depth/optical_depth.glsl"

uniform float clamp_alpha;
#ifdef TRIGONOMETRIC
uniform float angle_range;  // of the depths; the rest of a turn is between the last and the first
#endif

layout(location = 0) out vec2 total;    // sums of tau, and of how near it is
layout(location = 1) out vec4 moments;  // sums of tau z, …, tau z^4; or cos and sin of phi, 2 phi
#if MOMENTS == 6
layout(location = 2) out vec2 more;  // sums of tau z^5, tau z^6; or cos and sin of 3 phi
#elif MOMENTS == 8
layout(location = 2) out vec4 more;  // … and tau z^7, tau z^8; or of 4 phi
#endif

// Their values for a fragment of optical depth 1.
void basis(float d, out vec4 first, out vec4 last) {
#ifdef TRIGONOMETRIC
  float phi = angle_range * d;
  vec2 w1 = vec2(cos(phi), sin(phi));
  vec2 w2 = vec2(w1.x * w1.x - w1.y * w1.y, 2.0 * w1.x * w1.y);
  vec2 w3 = vec2(w1.x * w2.x - w1.y * w2.y, w1.x * w2.y + w1.y * w2.x);
  first = vec4(w1, w2);
  last = vec4(w3, w2.x * w2.x - w2.y * w2.y, 2.0 * w2.x * w2.y);
#else
  float z = 2.0 * d - 1.0, z2 = z * z, z4 = z2 * z2;
  first = vec4(z, z2, z2 * z, z4);
  last = z4 * first;
#endif
}

void main() {
  Fragment f = fragment();
  vec4 first, last;
  basis(f.depth, first, last);
  float tau = optical_depth(min(f.alpha, clamp_alpha));
  total = vec2(tau, nearness(f.depth));
  moments = tau * first;
#if MOMENTS == 6
  more = tau * last.xy;
#elif MOMENTS == 8
  more = tau * last;
#endif
}
