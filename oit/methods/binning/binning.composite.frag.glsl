// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/stage/composite.glsl"
#include "oit/optical_depth/optical_depth.glsl"

layout(binding = color_sums_texture) uniform sampler2D sums;
layout(binding = coefficients_image, r32ui) uniform uimage2DArray bins;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 sum = texelFetch(sums, pixel, 0);
  float tau = uintBitsToFloat(imageLoad(bins, ivec3(pixel, BINS - 1)).r);
  float alpha = opacity(tau);
#if NORMALIZE
  composite_mean(sum, alpha);  // Eq. 19
#else
  picture = over(vec4(sum.rgb, alpha), behind());  // Eq. 15
#endif
}
