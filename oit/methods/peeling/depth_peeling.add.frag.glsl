// SPDX-License-Identifier: GPL-3.0-or-later
// Blends the peeled layer under those before it.
#include "oit/gl/bindings.glsl"

layout(binding = peeled_layer_texture) uniform sampler2D layer;
layout(binding = peeled_layer_key_texture) uniform usampler2D layer_key;

layout(location = 0) out vec4 sum;
layout(location = 1) out uvec2 peeled;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 c = texelFetch(layer, pixel, 0);
  if (c.a < 0.0) discard;  // cleared: the pixel had nothing left
  sum = vec4(c.a * c.rgb, c.a);
  peeled = texelFetch(layer_key, pixel, 0).xy;
}
