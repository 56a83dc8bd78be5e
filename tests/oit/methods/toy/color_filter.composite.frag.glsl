// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/stage/composite.glsl"

layout(binding = own_texture) uniform sampler2D filters;

void main() {
  vec4 passed = texelFetch(filters, ivec2(gl_FragCoord.xy), 0);
  vec4 light = behind();
  picture = vec4(passed.rgb * light.rgb, 1.0 - passed.a * (1.0 - light.a));
}
