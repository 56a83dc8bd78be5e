// SPDX-License-Identifier: GPL-3.0-or-later
// The last pass of every method: one layer of `color` and `opacity` over the background.
#include "oit/gl/bindings.glsl"
#include "oit/stage/front_to_back.glsl"

layout(location = 0) out vec4 picture;

// Colour and opacity, premultiplied, of what lies behind the transparent layers: the background,
// whose opacity counts as 0, or the nearest opaque fragment.
#ifdef OPAQUE_CONTEXT
layout(binding = opaque_picture_texture) uniform sampler2D opaque_picture;
vec4 behind() { return texelFetch(opaque_picture, ivec2(gl_FragCoord.xy), 0); }
#else
uniform vec3 background;
vec4 behind() { return vec4(background, 0.0); }
#endif

void composite(vec3 color, float alpha) { picture = mix(behind(), vec4(color, 1.0), alpha); }

// A weighted mean: the sum of w C and of w. A pixel whose fragments weigh nothing has no colour.
void composite_mean(vec4 sum, float alpha) {
  if (sum.a > 0.0) composite(sum.rgb / sum.a, alpha);
  else composite(vec3(0.0), 0.0);
}
