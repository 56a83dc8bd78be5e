// SPDX-License-Identifier: GPL-3.0-or-later
// Blends the nearest layer under those before it, the farthest over those behind it.
#include "oit/gl/bindings.glsl"

layout(binding = ends_texture) uniform usampler2D ends;
layout(binding = nearest_layer_texture) uniform sampler2D nearest_layer;
layout(binding = farthest_layer_texture) uniform sampler2D farthest_layer;

layout(location = 0) out vec4 front;
layout(location = 1) out vec4 back;
layout(location = 2) out uvec4 left;

vec4 premultiplied(vec4 layer) { return vec4(layer.a * layer.rgb, layer.a); }

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  uvec4 found = texelFetch(ends, pixel, 0);
  if (found == uvec4(0u)) discard;  // the pixel had nothing left
  bool last_one = ~found.xy == found.zw;
  front = premultiplied(texelFetch(nearest_layer, pixel, 0));
  back = last_one ? vec4(0.0) : premultiplied(texelFetch(farthest_layer, pixel, 0));
  left = ~found;
}
