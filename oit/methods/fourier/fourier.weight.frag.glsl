// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/shapes/fragment.glsl"
#include "oit/optical_depth/fourier_sample.glsl"
#include "oit/optical_depth/optical_weight.glsl"

uniform float clamp_alpha;
uniform float margin;  // of the series' period on either side of [0, 1]
#if PRECISION == 16
layout(binding = coefficients_image, rgba16f) readonly uniform image2DArray coefficients;
#else
layout(binding = coefficients_image, rgba32f) readonly uniform image2DArray coefficients;
#endif

layout(location = 0) out vec4 sums;  // sum of C w, sum of w

FOURIER_SUM(tau_at, coefficients, BANDS, ivec2(gl_FragCoord.xy))

void main() {
  Fragment f = fragment();
  float d = place_in_period(f.depth, margin);
  float alpha = min(f.alpha, clamp_alpha);
  float tau = tau_at(d);
  float w = MIDDLE == 1 ? optical_weight_middle(alpha, tau) : optical_weight(alpha, tau);
  sums = vec4(f.color * w, w);
}
