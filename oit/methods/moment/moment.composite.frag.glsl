// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/stage/composite.glsl"
#include "oit/optical_depth/optical_depth.glsl"

layout(binding = coefficients_texture) uniform sampler2D total;
layout(binding = color_sums_texture) uniform sampler2D sums;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  composite_mean(texelFetch(sums, pixel, 0), opacity(texelFetch(total, pixel, 0).r));
}
