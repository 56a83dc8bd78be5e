// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/stage/composite.glsl"
#include "oit/optical_depth/optical_depth.glsl"

layout(binding = coefficients_texture) uniform sampler2DArray coefficients;
layout(binding = color_sums_texture) uniform sampler2D sums;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 sum = texelFetch(sums, pixel, 0);
  float tau = 0.5 * texelFetch(coefficients, ivec3(pixel, 0), 0).r;  // Eq. 18
  float alpha = opacity(tau);
#if NORMALIZE
  composite_mean(sum, alpha);  // Eq. 19
#else
  picture = over(vec4(sum.rgb, alpha), behind());  // Eq. 15
#endif
}
