// SPDX-License-Identifier: GPL-3.0-or-later
// Adds a sample to the sum.
#include "oit/gl/bindings.glsl"

layout(binding = sample_texture) uniform sampler2D nearest;

layout(location = 0) out vec4 sum;

void main() { sum = texelFetch(nearest, ivec2(gl_FragCoord.xy), 0); }
