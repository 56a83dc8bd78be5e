// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/stage/composite.glsl"

layout(binding = 0) uniform sampler2D samples;
layout(binding = 1) uniform sampler2D average;
layout(binding = 2) uniform sampler2D transmittance;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 hits = texelFetch(samples, pixel, 0);
  if (hits.a == 0.0) hits = texelFetch(average, pixel, 0);
  composite_mean(hits, 1.0 - texelFetch(transmittance, pixel, 0).r);
}
