// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/stage/composite.glsl"

layout(binding = front_sum_texture) uniform sampler2D front;
layout(binding = back_sum_texture) uniform sampler2D back;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 near = texelFetch(front, pixel, 0), far = texelFetch(back, pixel, 0);
  picture = over(near, over(far, behind()));
}
