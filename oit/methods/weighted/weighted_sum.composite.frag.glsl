// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/stage/composite.glsl"

layout(binding = weighted_sums_texture) uniform sampler2D sums;

void main() {
  vec4 sum = texelFetch(sums, ivec2(gl_FragCoord.xy), 0);
  picture = over(sum, behind());
#if CLAMP
  picture = clamp(picture, 0.0, 1.0);
#endif
}
