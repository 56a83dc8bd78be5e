// SPDX-License-Identifier: GPL-3.0-or-later
// Of the fragments at the nearest depth, the depth test keeps the first in the order of submission.
#include "oit/shapes/fragment.glsl"
#include "oit/methods/peeling/peel_key.glsl"

layout(binding = nearest_depth_texture) uniform sampler2D nearest;

layout(location = 0) out vec4 layer;
layout(location = 1) out uvec2 layer_key;

void main() {
  Fragment f = fragment();
  uvec2 key = key_of(f);
  if (f.depth != texelFetch(nearest, ivec2(gl_FragCoord.xy), 0).r || !is_left(key)) discard;
  layer = vec4(f.color, f.alpha);
  layer_key = key;
  // Normal floats below 1 order as their bits do: room for 10^9 triangles.
  gl_FragDepth = uintBitsToFloat(0x00800000u + key.y);
}
