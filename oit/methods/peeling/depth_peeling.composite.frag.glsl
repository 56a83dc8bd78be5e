// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/stage/composite.glsl"

layout(binding = peeled_sum_texture) uniform sampler2D sum;

void main() {
  picture = over(texelFetch(sum, ivec2(gl_FragCoord.xy), 0), behind());
}
