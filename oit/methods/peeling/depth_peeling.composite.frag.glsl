// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/stage/composite.glsl"

layout(binding = 0) uniform sampler2D sum;

void main() {
  vec4 c = texelFetch(sum, ivec2(gl_FragCoord.xy), 0);
  picture = c + (1.0 - c.a) * behind();
}
