// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/shapes/fragment.glsl"

layout(location = 0) out vec4 sums;  // sum of alpha C, sum of alpha
layout(location = 1) out float transmittance;

void main() {
  Fragment f = fragment();
  sums = vec4(f.alpha * f.color, f.alpha);
  transmittance = f.alpha;  // blended into the product of 1 - alpha
}
