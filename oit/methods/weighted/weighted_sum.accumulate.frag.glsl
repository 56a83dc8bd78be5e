// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/shapes/fragment.glsl"

layout(location = 0) out vec4 sums;  // sum of alpha C, sum of alpha

void main() {
  Fragment f = fragment();
  sums = vec4(f.alpha * f.color, f.alpha);
}
