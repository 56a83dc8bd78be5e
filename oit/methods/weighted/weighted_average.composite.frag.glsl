// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/stage/composite.glsl"
#include "oit/optical_depth/optical_depth.glsl"

layout(binding = weighted_sums_texture) uniform sampler2D sums;
layout(binding = fragment_count_texture) uniform sampler2D count;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 sum = texelFetch(sums, pixel, 0);
  float n = texelFetch(count, pixel, 0).r;
  float mean = min(sum.a / max(n, 1.0), 1.0);
  // (1 - mean)^n as exp(-n tau): a mean of 1e-8 would round 1 - mean to 1.
  float alpha = mean < 1.0 ? opacity(n * optical_depth(mean)) : 1.0;
  composite_mean(sum, alpha);
}
