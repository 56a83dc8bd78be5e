// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/stage/composite.glsl"
#include "oit/methods/k_buffer/k_nearest.glsl"

layout(binding = tail_texture) uniform sampler2D tail;
layout(binding = tail_transmittance_texture) uniform sampler2D tail_transmittance;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  Composite c = nothing;
  for (int i = 0; i < LAYERS && imageLoad(depths, ivec3(pixel, i)).r != EMPTY; ++i)
    add_layer(c, imageLoad(colors, ivec3(pixel, i)));
  vec4 sum = texelFetch(tail, pixel, 0);
  if (sum.a > 0.0)
    add_layer(c, vec4(sum.rgb / sum.a, 1.0 - texelFetch(tail_transmittance, pixel, 0).r));
  picture = over(c, behind());
}
