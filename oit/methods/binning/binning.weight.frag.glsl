// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/shapes/fragment.glsl"
#include "oit/optical_depth/optical_weight.glsl"

uniform float clamp_alpha;
layout(binding = coefficients_image, r32ui) uniform uimage2DArray bins;

layout(location = 0) out vec4 sums;  // sum of C w, sum of w

float tau_at_far_edge(int bin) {
  return uintBitsToFloat(imageLoad(bins, ivec3(gl_FragCoord.xy, bin)).r);
}

float tau_at(float d) {
  float x = d * float(BINS);
  int bin = min(int(x), BINS - 1);
  float far_tau = tau_at_far_edge(bin);
#if LINEAR
  float near_tau = bin > 0 ? tau_at_far_edge(bin - 1) : 0.0;
  return mix(near_tau, far_tau, x - float(bin));
#else
  return far_tau;
#endif
}

void main() {
  Fragment f = fragment();
  float w = optical_weight(min(f.alpha, clamp_alpha), tau_at(f.depth));
  sums = vec4(f.color * w, w);
}
