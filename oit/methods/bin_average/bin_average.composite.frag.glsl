// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/stage/composite.glsl"

layout(binding = gathered_bins_texture) uniform sampler2D gathered;

void main() { picture = over(texelFetch(gathered, ivec2(gl_FragCoord.xy), 0), behind()); }
