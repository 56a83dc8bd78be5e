// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/stage/composite.glsl"

layout(binding = sample_sum_texture) uniform sampler2D samples;
layout(binding = sample_average_texture) uniform sampler2D average;
layout(binding = sample_transmittance_texture) uniform sampler2D transmittance;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 hits = texelFetch(samples, pixel, 0);
  if (hits.a == 0.0) hits = texelFetch(average, pixel, 0);
  composite_mean(hits, 1.0 - texelFetch(transmittance, pixel, 0).r);
}
